#!/bin/sh
# Checks the links between the documents: every relative link of a Markdown file leads to a file, and its #part to a
# heading there.
#   links_test.sh ROOT
set -u
cd "$1" || exit 2

# check: prints the broken links, one on each line, and the number of links checked. Anchors of headings are as on
# GitHub: lower case, hyphens for blanks, no punctuation.
check() {
    find . \( -name node_modules -o -name 'build*' -o -name .git \) -prune -o -name '*.md' -print |
        LC_ALL=C.UTF-8 perl -CSD -Mutf8 -e '
            use strict; use warnings; use File::Basename; use File::Spec;
            my (%anchors, $count);
            sub text {
                open(my $file, "<:utf8", $_[0]) or return "";
                local $/;
                my $text = <$file>;
                $text =~ s/^```.*?^```$//gms;
                return $text;
            }
            sub anchors_of {
                my ($file) = @_;
                return $anchors{$file} //= do {
                    my %found;
                    for my $heading (text($file) =~ /^#+ (.*)$/gm) {
                        $heading =~ s/\[([^\]]*)\]\([^)]*\)/$1/g;
                        $heading = lc $heading;
                        $heading =~ s/[^\w\s-]//g;
                        $heading =~ s/ /-/g;
                        $found{$heading} = 1;
                    }
                    \%found;
                };
            }
            while (my $file = <STDIN>) {
                chomp $file;
                my $text = text($file);
                $text =~ s/`[^`\n]*`//g;
                while ($text =~ /\]\(([^)\s]+)\)/g) {
                    my $link = $1;
                    next if $link =~ /^[a-z]+:/;
                    ++$count;
                    my ($path, $part) = split /#/, $link, 2;
                    my $target = $path eq "" ? $file : File::Spec->catfile(dirname($file), $path);
                    if (!-e $target) { print "$file: $link: no such file\n" }
                    elsif (defined $part && !anchors_of($target)->{$part}) { print "$file: $link: no such heading\n" }
                }
            }
            print "only ", $count // 0, " links were found\n" if ($count // 0) < 100;
        '
}

found=$(check) || exit 2
if [ -n "$found" ]; then
    printf '%s\n' "$found"
    exit 1
fi

# The test finds a missing file and a missing heading.
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
printf '# A\n[a](#a) [b](#b) [c](c.md) [d](a.md#a)\n' >"$work/a.md"
cd "$work" || exit 2
expected="./a.md: #b: no such heading
./a.md: c.md: no such file
only 4 links were found"
[ "$(check)" = "$expected" ] || { echo "broken links are not seen"; check; exit 1; }

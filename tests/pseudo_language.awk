# A pseudo-language from lang/en.txt: every vowel of a text is doubled and accented, so that words are some 1.4 times as
# long and a word of another language is recognized. Places and letters in braces stay; of {0|one|several} the choices
# change. With the code of Italian, whose place it takes in the program of this test.
BEGIN {
    split("a:áa e:ée i:íi o:óo u:úu A:Áa E:Ée I:Íi O:Óo U:Úu", pairs, " ")
    for (i in pairs) longer[substr(pairs[i], 1, 1)] = substr(pairs[i], 3)
}
function lengthened(text,    out, i, c, depth, choice) {
    for (i = 1; i <= length(text); ++i) {
        c = substr(text, i, 1)
        if (c == "{") { ++depth; choice = 0 }
        if (c == "|" && depth > 0) choice = 1
        if (c == "}") --depth
        out = out ((depth == 0 || choice) && (c in longer) ? longer[c] : c)
    }
    return out
}
/^#/ { next }
/^== / { section = $2 }
/^== |^$/ { print; next }
section == "notation" { print($1 == "code" ? "code = it" : $0); next }
/^ / { print lengthened($0); next }
{
    equals = index($0, "=")
    print substr($0, 1, equals) lengthened(substr($0, equals + 1))
}

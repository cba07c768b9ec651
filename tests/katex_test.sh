#!/bin/sh
# katex_test.sh PROGRAM ROOT: KaTeX, which throws on any error, sets the LaTeX of every example's closure equations and
# of every point's derivatives, in Italian (decimal commas, accents). A faulty formula proves that the test can fail.
set -u
program=$1
examples=$2/examples
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

for file in "$examples"/*.json "$examples"/motion/*.json; do
    name=$(basename "$file" .json)
    for language in it; do
        "$program" equations "$file" --format latex --lang $language >"$work/$name-$language.tex" 2>/dev/null ||
            rm "$work/$name-$language.tex"
    done
done

cat >"$work/set.js" <<'JS'
const katex = require('katex');
const fs = require('fs');
let formulas = 0, wrong = 0;
const options = {displayMode: true, throwOnError: true, strict: (code) => code === 'unicodeTextInMathMode' ? 'error' : 'ignore'};
for (const path of process.argv.slice(2)) {
    const text = fs.readFileSync(path, 'utf8');
    for (const match of text.matchAll(/\\\[([^]*?)\\\]\n|\$([^$]*)\$/g)) {
        ++formulas;
        try {
            katex.renderToString(match[1] ?? match[2], options);
        } catch (fault) {
            if (++wrong <= 10) console.log(`${path}: ${match[1] ?? match[2]}: ${fault.message}`);
        }
    }
}
console.log(`${formulas} formulas, ${wrong} wrong`);
process.exit(wrong > 0 || formulas < 1000 ? 1 : 0);
JS

NODE_PATH=${NODE_PATH:-/usr/share/nodejs} nodejs "$work/set.js" "$work"/*.tex || exit 1
printf '\\[\\frac{a}\\]\n' >"$work/wrong.tex"
NODE_PATH=${NODE_PATH:-/usr/share/nodejs} nodejs "$work/set.js" "$work"/*.tex >/dev/null && exit 1
exit 0

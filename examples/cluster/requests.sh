#!/bin/sh
# Requests for `kinegraph batch`: so many cranks of the four-bar, all different, a line each (up to 10,000).
#   requests.sh [COUNT] [FILE] [WANTED] [FOLDER] >requests.jsonl
# WANTED is json (the default: results in the answers), or what is to go into files in FOLDER: svg, pdf, "json svg" …
set -eu
awk -v count="${1:-10000}" -v file="${2:-four_bar.json}" -v wanted="${3:-}" -v folder="${4:-out}" 'BEGIN {
    kinds = split(wanted, kind, " ")
    for (i = 1; i <= kinds; ++i) want = want (i > 1 ? ", " : "") "\"" kind[i] "\""
    for (n = 0; n < count; ++n) {
        # 200 lengths of the crank, 50 angles
        printf "{\"id\": %d, \"file\": \"%s\", \"set\": {\"r\": \"%.1f mm\", \"phi\": \"%d°\"}", n, file, 30 + n % 200 / 10, 20 + 2 * int(n / 200)
        if (kinds) printf ", \"want\": [%s], \"to\": \"%s/%05d\"", want, folder, n
        print "}"
    }
}'

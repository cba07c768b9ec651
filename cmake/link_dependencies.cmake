# The libraries that a program linked with Kinegraph needs. Included by our build and, installed, by
# find_package(kinegraph).
find_package(tl-expected REQUIRED)
find_package(pugixml REQUIRED)
pkg_check_modules(gmp REQUIRED IMPORTED_TARGET gmpxx gmp)
pkg_check_modules(mpfr REQUIRED IMPORTED_TARGET mpfr)
pkg_check_modules(ginac REQUIRED IMPORTED_TARGET ginac)
pkg_check_modules(cairo REQUIRED IMPORTED_TARGET cairo)
pkg_check_modules(harfbuzz REQUIRED IMPORTED_TARGET harfbuzz)
pkg_check_modules(harfbuzz_subset REQUIRED IMPORTED_TARGET harfbuzz-subset)
pkg_check_modules(freetype REQUIRED IMPORTED_TARGET freetype2)
pkg_check_modules(png REQUIRED IMPORTED_TARGET libpng)
pkg_check_modules(nettle REQUIRED IMPORTED_TARGET nettle)
pkg_check_modules(zip REQUIRED IMPORTED_TARGET libzip)

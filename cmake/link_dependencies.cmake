# The libraries that a program with Kinegraph in it links. Used by our build and, installed, by find_package(kinegraph).
find_package(tl-expected REQUIRED)
find_package(pugixml REQUIRED)
pkg_check_modules(gmp REQUIRED IMPORTED_TARGET gmpxx gmp)
pkg_check_modules(mpfr REQUIRED IMPORTED_TARGET mpfr)
pkg_check_modules(cairo REQUIRED IMPORTED_TARGET cairo)
pkg_check_modules(harfbuzz REQUIRED IMPORTED_TARGET harfbuzz)
pkg_check_modules(freetype REQUIRED IMPORTED_TARGET freetype2)
pkg_check_modules(png REQUIRED IMPORTED_TARGET libpng)

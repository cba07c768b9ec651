// The four faces of STIX General, from Debian's package fonts-stix.
.macro font name, file
    .section .rodata.\name,"",@
    .globl \name
    .globl \name\()_end
    .p2align 4
\name:
    .incbin "\file"
\name\()_end:
    .size \name, \name\()_end-\name
    .byte 0
    .size \name\()_end, 1
.endm

font stix_regular, "STIXGeneral-Regular.otf"
font stix_italic, "STIXGeneral-Italic.otf"
font stix_bold, "STIXGeneral-Bold.otf"
font stix_bold_italic, "STIXGeneral-BoldItalic.otf"

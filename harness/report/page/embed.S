/* The files that CMakeLists.txt lists as this one's dependencies, found along its include path. */
        .macro  embed name, file
        .global \name
        .global \name\()End
        .balign 16
\name:
        .incbin "\file"
\name\()End:
        .endm

        .section .rodata
        embed   kEtalonPageHtml, "page.html"
        embed   kEtalonPageStyle, "page.css"
        embed   kEtalonPageScript, "page.js"
        embed   kEtalonPageSchema, "schema.json"

        .section .note.GNU-stack, "", %progbits

/* The files that CMakeLists.txt lists as this one's dependencies, found along its include path. */
        .macro  embed name, file
        .global \name
        .global \name\()_end
        .balign 16
\name:
        .incbin "\file"
\name\()_end:
        .endm

        .section .rodata
        embed   etalon_page_html, "page.html"
        embed   etalon_page_css, "page.css"
        embed   etalon_page_js, "page.js"
        embed   etalon_page_schema, "schema.json"

        .section .note.GNU-stack, "", %progbits

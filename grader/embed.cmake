# Makes a string literal of a text, for #include: cmake -D FROM=page.css -D TO=page.css.inc -P embed.cmake
file(READ ${FROM} text)
file(WRITE ${TO} "R\"~~~(${text})~~~\"\n")

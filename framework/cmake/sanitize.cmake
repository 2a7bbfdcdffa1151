# TESTAT_SANITIZE="address,undefined" or "thread" instruments everything below the directory that includes this first.
include_guard(GLOBAL)

set(TESTAT_SANITIZE "" CACHE STRING "Sanitizers for all targets, as for -fsanitize=")
if(TESTAT_SANITIZE)
  add_compile_options(-fsanitize=${TESTAT_SANITIZE} -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${TESTAT_SANITIZE})
endif()

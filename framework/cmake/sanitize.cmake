# TESTAT_SANITIZE="address,undefined" or "thread" instruments everything below the directory that includes this first, and
# whoever links testat_sanitize from elsewhere.
include_guard(GLOBAL)

set(TESTAT_SANITIZE "" CACHE STRING "Sanitizers for all targets, as for -fsanitize=")
add_library(testat_sanitize INTERFACE)
if(TESTAT_SANITIZE)
  set(sanitize -fsanitize=${TESTAT_SANITIZE} -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  add_compile_options(${sanitize})
  add_link_options(-fsanitize=${TESTAT_SANITIZE})
  target_compile_options(testat_sanitize INTERFACE ${sanitize})
  target_link_options(testat_sanitize INTERFACE -fsanitize=${TESTAT_SANITIZE})
endif()

#!/bin/bash
# symbols_test.sh LIBRARY EXERCISE_OBJECT: the student's functions are defined by the exercise file alone, and the
# vtables and type information of their classes by the framework alone.
set -u
library=$1
exercise=$2
student='ImageTexture::(evaluate_nearest|wrap_clamp|wrap_repeat|evaluate_bilinear|create_mipmap|evaluate_trilinear)\(
Object::(compute_uv_aabb_size|intersect)\(
transform_(direction|position|direction_to_object_space)\('
framework='(vtable|typeinfo) for (Object|ImageTexture|Texture)$'

# "T name" for what other files can link with; compilers also split functions into local parts.
defined() { nm -C --defined-only --extern-only "$1" 2>/dev/null | cut -c 18-; }
failures=0
fail() { echo "$1"; failures=1; }

[ "$(defined "$exercise" | cut -c 3- | grep -cE "^(${student//$'\n'/|})")" = 11 ] || fail "the exercise file lacks functions"
defined "$library" | cut -c 3- | grep -E "^(${student//$'\n'/|})" && fail "the framework defines the student's functions"
[ "$(defined "$library" | grep -cE "$framework")" = 6 ] || fail "the framework lacks vtables"
defined "$exercise" | grep -E "$framework" && fail "the exercise file has vtables"
exit $failures

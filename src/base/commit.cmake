# Writes the source file TO that says which commit SOURCE is at and of which LIBRARIES it is built, if that has changed.
set(commit)
set(top)
if(GIT)
  execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse --show-toplevel
    OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  file(REAL_PATH ${SOURCE} SOURCE)
endif()
# Sources unpacked within another repository have no commit of their own
if(top STREQUAL SOURCE)
  execute_process(COMMAND ${GIT} -C ${SOURCE} describe --always --dirty --exclude=*
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(commit MATCHES "-dirty$")
    execute_process(COMMAND ${GIT} -C ${SOURCE} diff HEAD OUTPUT_VARIABLE difference ERROR_QUIET)
    string(SHA1 difference "${difference}")
    string(SUBSTRING ${difference} 0 7 difference)
    string(APPEND commit -${difference})
  endif()
endif()
if(NOT commit)
  set(commit unknown)
endif()
file(CONFIGURE OUTPUT ${TO} @ONLY CONTENT [[
#include "drape/base/commit.h"

namespace drape {

std::string commit() { return "@commit@"; }

std::string libraries() { return "@LIBRARIES@"; }

}  // namespace drape
]])

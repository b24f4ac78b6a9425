# Writes FOLDER/NAME.1, the manual page of each of PROGRAMS that has been built, from what its --help prints.
foreach(program IN LISTS PROGRAMS)
  if(NOT EXISTS ${program})
    continue()
  endif()
  execute_process(COMMAND ${program} --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${program} --version OUTPUT_VARIABLE version COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCH "^[^\n]*" version "${version}")
  string(STRIP "${help}" help)
  # What begins a request at the start of a line, and what is not to become a hyphen
  string(REPLACE "\\" "\\e" help "${help}")
  string(REPLACE "-" "\\-" help "${help}")
  string(REGEX REPLACE "(^|\n)([.'])" "\\1\\\\&\\2" help "${help}")
  string(REGEX MATCH "^[^\n]*" line "${help}")
  string(REGEX REPLACE "^[^\n]*\n+" "" help "${help}")
  get_filename_component(name ${program} NAME)
  string(TOUPPER ${name} title)
  string(REPLACE "-" "\\-" shown ${name})
  file(WRITE ${FOLDER}/${name}.1 ".TH ${title} 1 \"\" \"${version}\"
.SH NAME
${shown} \\- ${line}
.SH DESCRIPTION
.nf
${help}
.fi
.SH EXIT STATUS
0: done; 1: the run failed; 2: bad input.
")
  file(ARCHIVE_CREATE OUTPUT ${FOLDER}/${name}.1.gz PATHS ${FOLDER}/${name}.1 FORMAT raw COMPRESSION GZip)
  file(REMOVE ${FOLDER}/${name}.1)
endforeach()

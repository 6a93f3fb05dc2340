# run(command...): runs a command; a script that includes this stops where one fails.

function (run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status)
  if (NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "'${command}' failed (${status})")
  endif ()
endfunction ()

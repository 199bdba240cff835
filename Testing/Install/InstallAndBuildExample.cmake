# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause

# Installs the build tree `build` below `folder` and moves the installation, so that nothing can rely
# on its first place. Then configures, builds and tests the project `example` with it, and imports
# the package in `python_destination` with the interpreter `python`, if that is given.

set(prefix "${folder}/prefix")
set(example_build "${folder}/example")
file(REMOVE_RECURSE "${folder}/first" "${prefix}" "${example_build}")

function (run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction ()

run("${CMAKE_COMMAND}" --install "${build}" --prefix "${folder}/first" --config "${config}")
file(RENAME "${folder}/first" "${prefix}")
run("${CMAKE_COMMAND}" -G "${generator}" -S "${example}" -B "${example_build}"
  "-DCMAKE_PREFIX_PATH=${prefix}" "-DCMAKE_BUILD_TYPE=${config}")
run("${CMAKE_COMMAND}" --build "${example_build}" --config "${config}")
run("${CMAKE_CTEST_COMMAND}" --test-dir "${example_build}" --build-config "${config}"
  --output-on-failure --no-tests=error)

if (python)
  set(package_folder "${prefix}/${python_destination}")
  set(ENV{PYTHONPATH} "${package_folder}:$ENV{PYTHONPATH}")
  file(WRITE "${folder}/import.py"
    "import surfacedenoising\n"
    "assert surfacedenoising.__file__.startswith('${package_folder}'), surfacedenoising.__file__\n"
    "surfacedenoising.vtkOFFReader()\n")
  run("${python}" "${folder}/import.py")
endif ()

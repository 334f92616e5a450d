# Run by cpack on the staged files of every package: copyright, changelog, a compressed manual page, no run path.
cmake_minimum_required(VERSION 3.25)
set(names "library=${CPACK_DEBIAN_LIBRARY_PACKAGE_NAME}" "development=libwirecut-dev" "command=wirecut"
          "python=python3-wirecut")
foreach(name ${names})
  string(REPLACE "=" ";" pair ${name})
  list(GET pair 0 component)
  list(GET pair 1 package)
  set(stage ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr)
  if(NOT EXISTS ${stage})
    continue()
  endif()

  # Debian wants the copyright under the package's own name, and the licence by reference
  set(doc ${stage}/share/doc/${package})
  file(REMOVE_RECURSE ${stage}/share/doc)
  file(MAKE_DIRECTORY ${doc})
  file(WRITE ${doc}/copyright "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: Wirecut

Files: *
Copyright: (C) 2026 the Wirecut authors
License: GPL-3.0-or-later
 On Debian systems, the full text of the GNU General Public License
 version 3 can be found in /usr/share/common-licenses/GPL-3.
")
  file(WRITE ${doc}/changelog "wirecut (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium

  * Version ${CPACK_PACKAGE_VERSION}.

 -- ${CPACK_PACKAGE_CONTACT}  Mon, 30 Nov 2026 00:00:00 +0000
")
  execute_process(COMMAND gzip -9n ${doc}/changelog COMMAND_ERROR_IS_FATAL ANY)

  file(GLOB pages ${stage}/share/man/man*/*.[0-9])
  foreach(page ${pages})
    execute_process(COMMAND gzip -9n ${page} COMMAND_ERROR_IS_FATAL ANY)
  endforeach()

  # the system's loader finds the libraries
  file(GLOB binaries ${stage}/bin/* ${stage}/lib/*/lib*.so.*.*.*)
  foreach(binary ${binaries})
    file(RPATH_REMOVE FILE ${binary})
  endforeach()
endforeach()

# Debian packages of the release build: libwirecut0.1 (both libraries), libwirecut-dev, wirecut (command, manual page,
# completion), python3-wirecut. packages_stage.cmake brings what Debian's policy asks of each.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME wirecut)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_VENDOR "Wirecut")
set(CPACK_PACKAGE_CONTACT "Wirecut maintainers <maintainers@wirecut.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "spatial hot-wire cutting")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL library development command python)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_BINARY_DIR})
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/packages_stage.cmake)

set(WCUT_RUNTIME libwirecut${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(WCUT_ABOUT "Wirecut simulates a hot wire that two robot arms draw through foam,
 makes the cut surface and closed mould halves, compares scans and
 recordings with the simulation and explains how they differ.")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME ${WCUT_RUNTIME})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SHLIBDEPS ON)
set(WCUT_CONTROL ${CMAKE_BINARY_DIR}/control)
file(WRITE ${WCUT_CONTROL}/triggers "activate-noawait ldconfig\n")
file(WRITE ${WCUT_CONTROL}/shlibs "")
foreach(library libwirecut libwirecut-io)
  file(APPEND ${WCUT_CONTROL}/shlibs
       "${library} ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} ${WCUT_RUNTIME} (>= ${PROJECT_VERSION})\n")
endforeach()
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${WCUT_CONTROL}/triggers ${WCUT_CONTROL}/shlibs)
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "spatial hot-wire cutting, shared libraries\n ${WCUT_ABOUT}")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libwirecut-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${WCUT_RUNTIME} (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "spatial hot-wire cutting, headers\n ${WCUT_ABOUT}")

set(CPACK_DEBIAN_COMMAND_PACKAGE_NAME wirecut)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_COMMAND_PACKAGE_DEPENDS "${WCUT_RUNTIME} (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_COMMAND_DESCRIPTION "spatial hot-wire cutting, command\n ${WCUT_ABOUT}")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-wirecut)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3:any (>= 3.9), python3-numpy, python3-cffi-backend, python3-cffi, ${WCUT_RUNTIME} (>= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "spatial hot-wire cutting, Python package\n ${WCUT_ABOUT}")

include(CPack)

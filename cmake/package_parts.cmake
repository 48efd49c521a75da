# Read by cpack for each kind of package. Debian's packages depend on the libraries that they need; the tarball contains
# the libraries that other systems have in other versions.
if(CPACK_GENERATOR STREQUAL "DEB")
  set(CPACK_COMPONENTS_ALL jointwise jointwise-dev)
else()
  set(CPACK_COMPONENTS_ALL jointwise jointwise-dev bundled)
  set(CPACK_COMPONENT_INCLUDE_TOPLEVEL_DIRECTORY ON)
  set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
  set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
endif()

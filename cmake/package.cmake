# A Debian package: cpack -G DEB in a build folder of the preset `portable` (doc/building.md).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The clothbench authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "verification and benchmarks of cloth models")
set(CPACK_PACKAGE_DESCRIPTION
    "Runs models of the same sheet through the same scenes, compares them with truths that have
 error bars, and reports speed against error.")
set(CPACK_PACKAGE_FILE_NAME clothbench_${PROJECT_VERSION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # libraries, of the program and of what mpirun loads
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3, python3-numpy, python3-h5py, python3-matplotlib, python3-jinja2, python3-markdown")
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/clothbench RENAME copyright)
include(CPack)

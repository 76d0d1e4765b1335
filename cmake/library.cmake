# The models for other programs: an archive of all of them with scenes, settings and truths,
# headers, and what find_package and pkg-config ask for. doc/library.md
set(storeys "")
foreach(folder models linalg net solid ${MODEL_FOLDERS} bench)
  list(APPEND storeys $<TARGET_OBJECTS:cloth_${folder}>)
endforeach()
add_library(clothbench_archive STATIC ${storeys})
set_target_properties(clothbench_archive PROPERTIES OUTPUT_NAME clothbench LINKER_LANGUAGE C)
install(TARGETS clothbench_archive ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
foreach(folder models bench/files bench/harness bench/truth)
  install(DIRECTORY ${folder} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/clothbench/${folder}/..
          FILES_MATCHING PATTERN *.h)
endforeach()

set(LIBRARY_MODULES "yaml-0.1 lapacke openblas zlib libzip")
set(LIBRARY_FILES ${CHOLMOD_LIBRARY} ${ARPACK_LIBRARY} ${HDF5_C_LIBRARIES})
list(JOIN LIBRARY_FILES " " LIBRARY_FLAGS)
file(RELATIVE_PATH LIBRARY_TO_PREFIX ${CMAKE_INSTALL_FULL_LIBDIR}/cmake/clothbench
     ${CMAKE_INSTALL_PREFIX})
configure_file(cmake/clothbench.pc.in clothbench.pc @ONLY)
configure_file(cmake/clothbenchConfig.cmake.in clothbenchConfig.cmake @ONLY)
include(CMakePackageConfigHelpers)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/clothbenchConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/clothbench.pc
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
install(FILES ${CMAKE_BINARY_DIR}/clothbenchConfig.cmake
              ${CMAKE_BINARY_DIR}/clothbenchConfigVersion.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/clothbench)

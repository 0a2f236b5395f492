# Files installed beside the programs, and the .deb package.
include(GNUInstallDirs)
install(DIRECTORY profiles DESTINATION ${CMAKE_INSTALL_DATADIR}/gsbench)
install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY bench/ci DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples USE_SOURCE_PERMISSIONS)
install(
  FILES LICENSE
  DESTINATION ${CMAKE_INSTALL_DOCDIR}
  RENAME copyright)

# `./dev package` builds only the installed targets, not the tests.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "gsbench engineers <gsbench@localhost>")
set(CPACK_PACKAGE_DESCRIPTION
    "gsbench generates the frequency response of a power system, plays it as a mains voltage into
outlets that shed load on a falling frequency, records what they measured, estimated and switched,
and writes reports with pass/fail verdicts.")
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION electronics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# For emulated stations.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "qemu-system-arm, mosquitto, openssl")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS bash-completion)
include(CPack)

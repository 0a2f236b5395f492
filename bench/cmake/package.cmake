# Files installed beside the programs, and the .deb package.
include(GNUInstallDirs)
install(DIRECTORY profiles drivers/source/scpi/instruments DESTINATION ${CMAKE_INSTALL_DATADIR}/gsbench)
install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(PROGRAMS bench/ci/check-firmware DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples/ci)
install(FILES bench/ci/README.md bench/ci/gitlab-ci.yml bench/ci/station.toml
        DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples/ci)
install(
  FILES firmware/wire/README.md
  DESTINATION ${CMAKE_INSTALL_DOCDIR}
  RENAME protocol.md)
install(FILES firmware/wire/exchange.md firmware/wire/mqtt.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(
  FILES LICENSE
  DESTINATION ${CMAKE_INSTALL_DOCDIR}
  RENAME copyright)

# A package does not depend on the umask of its builder.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

# `./dev package` builds only the installed targets, not the tests.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "gsbench engineers <gsbench@localhost>")
set(CPACK_PACKAGE_DESCRIPTION
    "gsbench generates the frequency response of a power system and plays it
as a mains voltage into outlets that shed load on a falling frequency. It
records their measurements, estimates and relay operations, and writes
reports with pass/fail verdicts.")
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION electronics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# For emulated stations.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "qemu-system-arm, mosquitto, openssl")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS bash-completion)
include(CPack)

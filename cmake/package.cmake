# What is installed beside the program, and the Debian package of it (scripts/package).

set(packaging ${PROJECT_SOURCE_DIR}/packaging)
install(TARGETS covaria RUNTIME DESTINATION bin)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/projects ${PROJECT_SOURCE_DIR}/resources DESTINATION share/covaria)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/ DESTINATION share/doc/covaria FILES_MATCHING PATTERN *.md PATTERN *.png)
install(FILES ${packaging}/copyright DESTINATION share/doc/covaria)
install(FILES ${packaging}/covaria.desktop DESTINATION share/applications)
install(FILES ${packaging}/covaria.xml DESTINATION share/mime/packages)
install(FILES ${packaging}/covaria.metainfo.xml DESTINATION share/metainfo)
install(FILES ${PROJECT_SOURCE_DIR}/resources/icons/covaria.svg DESTINATION share/icons/hicolor/scalable/apps)

# The program describes its command line itself.
set(described ${PROJECT_BINARY_DIR}/described)
install(CODE "
    file(MAKE_DIRECTORY ${described})
    foreach(form man-page bash-completion)
        execute_process(COMMAND $<TARGET_FILE:covaria> manual \${form} OUTPUT_FILE ${described}/\${form} COMMAND_ERROR_IS_FATAL ANY)
    endforeach()
    foreach(form html pdf)
        execute_process(COMMAND $<TARGET_FILE:covaria> manual \${form} -o ${described}/manual.\${form} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
    endforeach()
    execute_process(COMMAND gzip -9nc ${PROJECT_SOURCE_DIR}/CHANGELOG.md OUTPUT_FILE ${described}/changelog.gz COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND gzip -9nc ${described}/man-page OUTPUT_FILE ${described}/covaria.1.gz COMMAND_ERROR_IS_FATAL ANY)")
install(FILES ${described}/covaria.1.gz DESTINATION share/man/man1)
install(FILES ${described}/changelog.gz ${described}/manual.html ${described}/manual.pdf DESTINATION share/doc/covaria)
install(FILES ${described}/bash-completion DESTINATION share/bash-completion/completions RENAME covaria)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME covaria)
set(CPACK_PACKAGE_VENDOR Covaria)
set(CPACK_PACKAGE_CONTACT "The Covaria developers <covaria@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "measurement uncertainty of robots and large-scale metrology")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Covaria describes artefacts, instruments, robots and typed measurement equations, propagates their
uncertainties (law of propagation and Monte Carlo, JCGM 100, 101 and 102) and writes budgets, reports and certificates.")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What is loaded at run time and therefore not found by its linking: pictures of icons, fonts, drawing without a display.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3, python3-numpy")  # of the Python module
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libqt6svg6, fonts-inter, fonts-liberation2, fonts-stix, libgl1-mesa-dri")
include(CPack)

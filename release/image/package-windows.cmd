@echo off
rem Makes an installer for Windows with jpackage: release\image\package-windows.cmd JAR FOLDER. Not tried yet.
rem Needs the JDK of the image in JAVA_HOME, and the WiX tools that jpackage names.
setlocal EnableExtensions DisableDelayedExpansion
if "%~2"=="" goto usage
if not exist "%~1" goto usage
set "LUMBRE_OUT=%TEMP%\lumbre-image-%RANDOM%"
pushd "%~dp0..\.."
"%JAVA_HOME%\bin\java.exe" release\image\BuildImage.java "%~1" "%LUMBRE_OUT%"
if errorlevel 1 goto failed
for /f "tokens=2 delims= " %%a in ('call "%LUMBRE_OUT%\bin\lumbre.cmd" --version') do if not defined LUMBRE_VERSION set "LUMBRE_VERSION=%%a"
for /f "tokens=1 delims=-" %%a in ("%LUMBRE_VERSION%") do set "LUMBRE_VERSION=%%a"
"%JAVA_HOME%\bin\jpackage.exe" --type msi --name lumbre --dest "%~2" --input "%LUMBRE_OUT%\lib\app" --main-jar lumbre.jar --runtime-image "%LUMBRE_OUT%\lib\runtime" --app-version %LUMBRE_VERSION% --vendor "The Lumbre authors" --win-console --java-options --add-modules=jdk.incubator.vector
if errorlevel 1 goto failed
popd
rmdir /s /q "%LUMBRE_OUT%"
exit /b 0

:failed
popd
exit /b 7

:usage
echo usage: release\image\package-windows.cmd target\lumbre-all.jar FOLDER>&2
exit /b 2

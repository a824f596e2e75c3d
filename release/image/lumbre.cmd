@echo off
rem Runs Lumbre with the Java of its runtime image. Environment:
rem   LUMBRE_JAVA_OPTS  more options for the virtual machine, such as -Xmx8g
setlocal EnableExtensions DisableDelayedExpansion
set "LUMBRE_IMAGE=%~dp0.."
"%LUMBRE_IMAGE%\lib\runtime\bin\java.exe" "@%LUMBRE_IMAGE%\lib\app\options" "@%LUMBRE_IMAGE%\lib\app\cache.options" "-XX:SharedArchiveFile=%LUMBRE_IMAGE%\lib\app\lumbre.jsa" %LUMBRE_JAVA_OPTS% "-Dlumbre.home=%LUMBRE_IMAGE%\share\lumbre" -cp "%LUMBRE_IMAGE%\lib\app\lumbre.jar" io.github.lumbre.cli.Lumbre %*
exit /b %ERRORLEVEL%

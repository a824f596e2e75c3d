@echo off
rem Runs Lumbre, and builds it first if that is needed. Environment:
rem   JAVA_HOME         the JDK to use; without it, the java on the PATH
rem   LUMBRE_JAVA_OPTS  more options for the virtual machine, such as -Xmx8g
setlocal EnableExtensions DisableDelayedExpansion
set "LUMBRE_HOME=%~dp0"
set "LUMBRE_JAR=%LUMBRE_HOME%target\lumbre-all.jar"
set "LUMBRE_LOCK=%LUMBRE_HOME%target\.lumbre-build"

rem Find Java.
set "LUMBRE_JAVA=java.exe"
if not defined JAVA_HOME goto search
set "LUMBRE_JAVA=%JAVA_HOME%\bin\java.exe"
if exist "%LUMBRE_JAVA%" goto version
echo lumbre: JAVA_HOME is "%JAVA_HOME%", which holds no bin\java.exe; a JDK 17 or newer is needed>&2
exit /b 7

:search
where /q java.exe
if not errorlevel 1 goto version
echo lumbre: found no Java; install a JDK 17 or newer, or set JAVA_HOME>&2
exit /b 7

:version
set "LUMBRE_VERSION="
set "LUMBRE_TOLD=%TEMP%"
if not exist "%LUMBRE_TOLD%\" set "LUMBRE_TOLD=%LUMBRE_HOME%."
set "LUMBRE_TOLD=%LUMBRE_TOLD%\lumbre-%RANDOM%%RANDOM%.txt"
"%LUMBRE_JAVA%" -version 2>"%LUMBRE_TOLD%"
for /f "usebackq tokens=2,3" %%a in ("%LUMBRE_TOLD%") do if "%%a"=="version" set "LUMBRE_VERSION=%%~b"
del /q "%LUMBRE_TOLD%" 2>nul
set "LUMBRE_MAJOR=0"
for /f "tokens=1 delims=.-+" %%a in ("%LUMBRE_VERSION%") do set "LUMBRE_MAJOR=%%a"
if %LUMBRE_MAJOR% GEQ 17 goto stale
echo lumbre: found Java "%LUMBRE_VERSION%" (%LUMBRE_JAVA%); a JDK 17 or newer is needed>&2
exit /b 7

:stale
if exist "%LUMBRE_LOCK%\" goto build
if not exist "%LUMBRE_JAR%" goto build
powershell -NoProfile -NonInteractive -Command "$t = (Get-Item -LiteralPath $env:LUMBRE_JAR).LastWriteTimeUtc; $f = @(Get-Item -LiteralPath ($env:LUMBRE_HOME + 'pom.xml')) + @(Get-ChildItem -LiteralPath ($env:LUMBRE_HOME + 'src\main') -Recurse); if ($f | Where-Object { $_.LastWriteTimeUtc -gt $t }) { exit 1 }"
if errorlevel 1 goto build
goto run

rem One build at a time: whoever makes the directory builds, the others wait for it to vanish.
:build
if not exist "%LUMBRE_HOME%target\" mkdir "%LUMBRE_HOME%target" 2>nul
if exist "%LUMBRE_HOME%target\" goto turn
:unwritable
echo lumbre: must be built first, but "%LUMBRE_HOME%target" cannot be written; make it writable, or use a copy of "%LUMBRE_HOME%">&2
exit /b 6

:turn
set LUMBRE_WAITS=0
:acquire
mkdir "%LUMBRE_LOCK%" 2>nul && goto locked
rem Another build may have ended just now: only a second failure means that nothing can be made here.
if not exist "%LUMBRE_LOCK%\" mkdir "%LUMBRE_LOCK%" 2>nul && goto locked
if not exist "%LUMBRE_LOCK%\" goto unwritable
if %LUMBRE_WAITS%==0 echo lumbre: waiting for another build>&2
set /a LUMBRE_WAITS+=1
if %LUMBRE_WAITS% GTR 600 goto abandoned
ping -n 2 127.0.0.1 >nul
if exist "%LUMBRE_LOCK%\" goto acquire
goto stale

:abandoned
echo lumbre: another build seems to have been ended; delete "%LUMBRE_LOCK%">&2
exit /b 7

:locked
echo lumbre: building, which takes about 65 s of one processor>&2
rem The build replaces the jar in one step. It gets the time of the build's beginning, so that whatever changes meanwhile counts
rem as newer.
pushd "%LUMBRE_HOME%"
call mvnw.cmd -q -B -Dmaven.test.skip=true package 1>&2 <nul
set "LUMBRE_BUILT=%ERRORLEVEL%"
popd
if "%LUMBRE_BUILT%"=="0" powershell -NoProfile -NonInteractive -Command "(Get-Item -LiteralPath $env:LUMBRE_JAR).LastWriteTimeUtc = (Get-Item -LiteralPath $env:LUMBRE_LOCK).LastWriteTimeUtc"
rmdir "%LUMBRE_LOCK%"
if "%LUMBRE_BUILT%"=="0" goto run
echo lumbre: the build failed; the old jar, if there is one, is kept. Windows replaces no jar that a running Lumbre uses: end it first>&2
exit /b 7

:run
set "LUMBRE_ARCHIVE="
rem Whether Java runs the program at all is tried only with options of the user's, and not with agents and recorders.
rem Some options make Java do something else, such as -version.
if not defined LUMBRE_JAVA_OPTS goto archive
set LUMBRE_JAVA_OPTS| findstr /c:"-agent" /c:"-javaagent" /c:"-Xrun" /c:"FlightRecord" >nul && goto parts
"%LUMBRE_JAVA%" "@%LUMBRE_HOME%src\main\jvm\options" %LUMBRE_JAVA_OPTS% -jar "%LUMBRE_JAR%" --version >"%LUMBRE_TOLD%" 2>&1
set "LUMBRE_STARTED=%ERRORLEVEL%"
set "LUMBRE_RUNS="
for /f "usebackq" %%a in ("%LUMBRE_TOLD%") do if "%%a"=="Lumbre" set "LUMBRE_RUNS=yes"
if not "%LUMBRE_STARTED%"=="0" type "%LUMBRE_TOLD%" >&2
del /q "%LUMBRE_TOLD%" 2>nul
set "LUMBRE_VERB=start"
if "%LUMBRE_STARTED%"=="0" set "LUMBRE_VERB=run Lumbre"
if "%LUMBRE_STARTED%%LUMBRE_RUNS%"=="0yes" goto parts
echo lumbre: LUMBRE_JAVA_OPTS: Java does not %LUMBRE_VERB% with "%LUMBRE_JAVA_OPTS%">&2
exit /b 2

rem From Java 24 on, the virtual machine itself writes an archive of the classes at the end of a render, and again when
rem it does not fit the jar or Java. All starts are faster from it; what does not fit is no news to the user.
:archive
if %LUMBRE_MAJOR% LSS 24 goto parts
set LUMBRE_ARCHIVE="-XX:SharedArchiveFile=%LUMBRE_HOME%target\lumbre-java-%LUMBRE_VERSION%.jsa" -Xlog:cds*=off -Xlog:aot*=off
if "%~1"=="render" set LUMBRE_ARCHIVE=-XX:+AutoCreateSharedArchive %LUMBRE_ARCHIVE%

:parts
"%LUMBRE_JAVA%" "@%LUMBRE_HOME%src\main\jvm\options" %LUMBRE_ARCHIVE% %LUMBRE_JAVA_OPTS% "-Dlumbre.home=%LUMBRE_HOME%." -jar "%LUMBRE_JAR%" %*
exit /b %ERRORLEVEL%

@echo off
rem Renders the table of the 2016 report and prints the times. --help tells more.
call "%~dp0lumbre.cmd" benchmark %*
exit /b %ERRORLEVEL%

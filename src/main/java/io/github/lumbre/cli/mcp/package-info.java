/**
 * A server of the Model Context Protocol, by which other programs have models rendered: {@link
 * io.github.lumbre.cli.mcp.McpServer} reads messages and starts calls, tools do the work, and
 * {@link io.github.lumbre.cli.mcp.Roots} confines them to folders.
 */
package io.github.lumbre.cli.mcp;

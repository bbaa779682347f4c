/* A small stand-alone Lua, for scripts/lua55.sh: the crate that carries the sources of Lua 5.5 leaves
 * out the program `lua`. It takes what the specs and scripts need: -e CODE, or FILE ARGUMENT... */

#include <stdio.h>
#include <string.h>

#include "lauxlib.h"
#include "lua.h"
#include "lualib.h"

static int add_traceback(lua_State *L) {
  const char *message = lua_tostring(L, 1);
  luaL_traceback(L, L, message ? message : luaL_tolstring(L, 1, NULL), 1);
  return 1;
}

/* As `lua` does: arg[0] is the file, what follows it counts from 1, the program is arg[-1]. */
static void set_arg(lua_State *L, int argc, char **argv) {
  lua_createtable(L, argc, 2);
  for (int i = 0; i < argc; i++) {
    lua_pushstring(L, argv[i]);
    lua_rawseti(L, -2, i - 1);
  }
  lua_setglobal(L, "arg");
}

int main(int argc, char **argv) {
  int is_code = argc == 3 && strcmp(argv[1], "-e") == 0;
  if (argc < 2 || (argv[1][0] == '-' && !is_code)) {
    fprintf(stderr, "usage: lua5.5 -e CODE | FILE ARGUMENT...\n");
    return 2;
  }
  lua_State *L = luaL_newstate();
  if (L == NULL) {
    fprintf(stderr, "lua5.5: not enough memory\n");
    return 1;
  }
  luaL_openlibs(L);
  set_arg(L, argc, argv);
  lua_pushcfunction(L, add_traceback);
  int status = is_code ? luaL_loadstring(L, argv[2]) : luaL_loadfile(L, argv[1]);
  int count = 0;
  if (status == LUA_OK && !is_code) {
    luaL_checkstack(L, argc, "too many arguments");
    for (; count < argc - 2; count++) {
      lua_pushstring(L, argv[count + 2]);
    }
  }
  if (status == LUA_OK) {
    status = lua_pcall(L, count, 0, 1);
  }
  if (status != LUA_OK) {
    fprintf(stderr, "lua5.5: %s\n", lua_tostring(L, -1));
  }
  lua_close(L);
  return status == LUA_OK ? 0 : 1;
}

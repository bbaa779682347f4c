/* A small stand-alone Lua 5.1 to 5.5, for scripts/puc_lua.sh: the crate that carries the sources
 * leaves out the program `lua`. It takes what the specs need: -e CODE, or FILE ARGUMENT... */

#include <stdio.h>
#include <string.h>

#include "lauxlib.h"
#include "lua.h"
#include "lualib.h"

static int add_traceback(lua_State *L) {
  lua_getglobal(L, "debug");
  lua_getfield(L, -1, "traceback");
  lua_getglobal(L, "tostring");
  lua_pushvalue(L, 1);
  lua_call(L, 1, 1);
  lua_call(L, 1, 1);
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
    fprintf(stderr, "usage: %s -e CODE | FILE ARGUMENT...\n", argv[0]);
    return 2;
  }
  lua_State *L = luaL_newstate();
  if (L == NULL) {
    fprintf(stderr, "%s: not enough memory\n", argv[0]);
    return 1;
  }
  luaL_openlibs(L);
  set_arg(L, argc, argv);
  lua_pushcfunction(L, add_traceback);
  int status = is_code ? luaL_loadstring(L, argv[2]) : luaL_loadfile(L, argv[1]);
  int count = 0;
  if (status == 0 && !is_code) {
    luaL_checkstack(L, argc, "too many arguments");
    for (; count < argc - 2; count++) {
      lua_pushstring(L, argv[count + 2]);
    }
  }
  if (status == 0) {
    status = lua_pcall(L, count, 0, 1);
  }
  if (status != 0) {
    fprintf(stderr, "%s: %s\n", argv[0], lua_tostring(L, -1));
  }
  lua_close(L);
  return status == 0 ? 0 : 1;
}

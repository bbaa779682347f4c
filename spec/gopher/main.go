// Runs one Lua file on gopher-lua, as `lua FILE ARGUMENTS` would.
package main

import (
	"fmt"
	"os"

	lua "github.com/yuin/gopher-lua"
)

func main() {
	L := lua.NewState()
	defer L.Close()
	args := L.NewTable()
	for i, value := range os.Args[2:] {
		args.RawSetInt(i+1, lua.LString(value))
	}
	args.RawSetInt(0, lua.LString(os.Args[1]))
	if self, err := os.Executable(); err == nil {
		args.RawSetInt(-1, lua.LString(self))
	}
	L.SetGlobal("arg", args)
	if err := L.DoFile(os.Args[1]); err != nil {
		fmt.Fprintln(os.Stderr, err)
		os.Exit(1)
	}
}

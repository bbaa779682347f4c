module physics.lua/spec/gopher

go 1.17

require github.com/yuin/gopher-lua v1.1.1

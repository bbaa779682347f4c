--- Numbers that change with every change of behaviour, each the same on every Lua. Written by
--- `make golden` (scripts/golden.sh), which looks that LuaJIT, its interpreter, 5.1 and 5.4 agree.
--- Every change of them is a **Behaviour** entry of the changelog.
return {
  everything = "97370194243799",
  games5000001 = "1045496232",
  games5000004 = "249550221",
  games5000009 = "466424559",
  snap = "18796326201591",
  wild = "2071681482",
}

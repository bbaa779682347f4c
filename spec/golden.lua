--- Numbers that change with every change of behaviour, each the same on every Lua. Written by
--- `make golden` (scripts/golden.sh), which looks that LuaJIT, its interpreter, 5.1 and 5.4 agree.
--- Every change of them is a **Behaviour** entry of the changelog.
return {
  everything = "69070669234925",
  games5000001 = "1169232549",
  games5000004 = "1048300037",
  games5000009 = "76093842",
  snap = "67445583540312",
  wild = "2071681482",
}

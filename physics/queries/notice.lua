--- Tells the index of the queries what has changed (see queries/index). A world that was never
--- asked has no index, and a program that never asks does not load it.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local view = require(root .. ".memory.lazy")(root .. ".queries.index")

local notice = {}

--- After a step: all objects are looked at before the next query.
function notice.outdate(b)
  if b.view then
    b.view.fresh = false
  end
end

--- An object was added or removed: the groups are looked at before the next query.
function notice.tell(b)
  if b.view then
    b.view.isTold = true
  end
end

--- The core has read an object anew, also the fields that it reads only once.
function notice.refresh(b, object)
  if b.view then
    view.refresh(b.view, object)
  end
end

return notice

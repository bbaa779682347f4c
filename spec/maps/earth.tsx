<?xml version="1.0" encoding="UTF-8"?>
<tileset version="1.8" tiledversion="1.8.2" name="earth" tilewidth="16" tileheight="16" tilecount="8" columns="8">
 <image source="earth.png" width="128" height="16"/>
 <tile id="0">
  <properties>
   <property name="collidable" value="true"/>
  </properties>
 </tile>
 <tile id="1" type="crate"/>
 <tile id="2">
  <properties>
   <property name="collidable" type="bool" value="true"/>
   <property name="oneWay" type="bool" value="true"/>
  </properties>
 </tile>
</tileset>

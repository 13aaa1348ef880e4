attitudes_mount = La caméra est tournée de { NUM($angle_deg, decimals: 0) }° par rapport aux attitudes de { $source }.

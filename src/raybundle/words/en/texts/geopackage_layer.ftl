geopackage_layer-displacements = displacements since the earlier date, at the earlier place; sd..: standard deviations; metres

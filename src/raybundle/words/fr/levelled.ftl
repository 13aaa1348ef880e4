levelled = Les altitudes des points d'appui sont inconnues : le bloc est nivelé selon sa direction de visée, à environ { NUM($angle_deg, decimals: 0) }°.

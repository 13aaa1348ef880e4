small_angle = { $n } point(s) objet intersecté(s) à moins de { $limit_deg }° : { $ids }.

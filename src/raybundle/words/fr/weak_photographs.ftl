weak_photographs = { $weak } photo(s) sur { $photographs } ont { $common } points communs avec moins de deux autres : { $ids }.

attitudes_steep = { $n } attitude(s) non utilisée(s) : { $ids }.

# $wrong = 2
# $excluded = true
# $rms_mm = 0.029
# $ids = ["12", "17"]
nominal_wrong = { $wrong } { $wrong ->
        [one] measured point deviates
       *[other] measured points deviate
     } from nominal far more than the others: { $ids }.
    .why = The others agree to { NUM($rms_mm, digits: 2) } mm rms; the axes are fitted { $excluded ->
        [yes] without them
       *[no] with them, as selected
     }.
    .do = Check their nominal coordinates and names.

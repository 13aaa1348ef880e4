# $photograph = "img_07.jpg"
photographs-targets = Targets of photograph { $photograph }:

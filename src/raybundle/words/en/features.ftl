# $name = "surf"
# $known = ["rootsift", "xfeat"]
features-unknown = Feature method { $name } is unknown.
    .do = Give one of { LIST($known, most: 20) }.

# $name = "xfeat"
# $packages = ["torch", "kornia"]
# $command = "pip install 'raybundle[learned]'"
features-not_installed = Feature method { $name } needs { $packages }.
    .do = Install: { $command }; or use rootsift, which needs nothing more.

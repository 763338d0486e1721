#include "app/output/folder_files.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "model/base/error.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace limitgauge::app {
namespace fs = std::filesystem;
namespace {

/// A folder `out` with files, and a secret beside it.
class Folder {
 public:
  Folder() {
    fs::create_directories(path("out/rough/deep"));
    write("secret.txt", "secret");
    write("out/report.html", "page");
    write("out/.hidden", "hidden");
    write("out/rough/toolpath.ngc", "G0 X0\nM2\n");
    write("out/rough/deep/a b%20.txt", "deep");
  }
  void write(const std::string& file, const std::string& text) const {
    std::ofstream(path(file)) << text;
  }
  fs::path path(const std::string& name) const { return folder_.path() / name; }

 private:
  tests::TemporaryFolder folder_;
};

std::string text_of(const FolderFiles& files, const std::string& path) {
  const std::shared_ptr<const OpenFile> file = files.open(path);
  return file ? file->read(0, file->bytes()) : "nothing";
}

TEST_CASE("files below the folder are read, in parts too", "[unit][view]") {
  const Folder folder;
  const FolderFiles files(folder.path("out"));
  CHECK(text_of(files, "report.html") == "page");
  CHECK(text_of(files, "rough/toolpath.ngc") == "G0 X0\nM2\n");
  CHECK(text_of(files, "rough/deep/a b%20.txt") == "deep");
  const std::shared_ptr<const OpenFile> file = files.open("rough/toolpath.ngc");
  CHECK(file->bytes() == 9);
  CHECK(file->read(3, 2) == "X0");
  CHECK(file->read(8, 100) == "\n");
  CHECK(file->read(9, 100).empty());
}

TEST_CASE("nothing leads out of the folder", "[unit][view]") {
  const Folder folder;
  const fs::path secret = folder.path("secret.txt");
  fs::create_symlink(secret, folder.path("out/link.txt"));
  fs::create_symlink("../..", folder.path("out/rough/up"));
  fs::create_symlink("report.html", folder.path("out/same.html"));
  REQUIRE(mkfifo(folder.path("out/pipe").c_str(), 0600) == 0);
  const FolderFiles files(folder.path("out"));
  for (const std::string path : {"../secret.txt",
                                 "rough/../../secret.txt",
                                 "/etc/passwd",
                                 "//etc/passwd",
                                 "link.txt",
                                 "rough/up/secret.txt",
                                 "same.html",
                                 ".hidden",
                                 "./report.html",
                                 "rough",
                                 "rough/",
                                 "",
                                 "/",
                                 "..",
                                 "rough//toolpath.ngc",
                                 "report.html/",
                                 "report.html/x",
                                 "pipe",
                                 "..\\secret.txt",
                                 "missing"}) {
    CAPTURE(path);
    CHECK(text_of(files, path) == "nothing");
  }
  CHECK(text_of(files, std::string("report.html\0.png", 16)) == "nothing");
  CHECK(text_of(files, std::string(5000, 'x')) == "nothing");
}

TEST_CASE("a folder that is moved away and replaced stays the one that was opened",
          "[unit][view]") {
  const Folder folder;
  const FolderFiles files(folder.path("out"));
  fs::rename(folder.path("out"), folder.path("old"));
  fs::create_directory(folder.path("out"));
  folder.write("out/report.html", "another");
  CHECK(text_of(files, "report.html") == "page");
  CHECK_THROWS_AS(FolderFiles(folder.path("missing")), model::InputError);
  CHECK_THROWS_AS(FolderFiles(folder.path("secret.txt")), model::InputError);
}

TEST_CASE("files say what they are", "[unit][view]") {
  CHECK(media_type("report.html") == "text/html; charset=utf-8");
  CHECK(media_type("result.json") == "application/json");
  CHECK(media_type("findings.sarif") == "application/sarif+json");
  CHECK(media_type("rough/stock.png") == "image/png");
  CHECK(media_type("rough/toolpath.ngc") == "text/plain; charset=utf-8");
  CHECK(media_type("rough/stock.vdb") == "application/octet-stream");
  CHECK(media_type("html") == "application/octet-stream");
}

}  // namespace
}  // namespace limitgauge::app

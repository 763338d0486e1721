#include "tests/e2e/program.h"
#include "tests/e2e/shell.h"
#include "tests/support/catch.h"
#include "tests/support/folders.h"

namespace limitgauge::e2e {
namespace fs = std::filesystem;
namespace {

TEST_CASE("what is installed stands where a system looks for it, and runs", "[e2e][install]") {
  const Scratch scratch;
  const fs::path prefix = scratch / "usr";
  const ShellOutcome installed = bash(
      "'" LIMITGAUGE_CMAKE "' --install '" LIMITGAUGE_BUILD "' --prefix '" + prefix.string() + "'");
  INFO(installed.out);
  REQUIRE(installed.exit_code == 0);
  for (const char* file :
       {"bin/limitgauge", "share/man/man1/limitgauge.1",
        "share/bash-completion/completions/limitgauge", "share/zsh/site-functions/_limitgauge",
        "share/fish/vendor_completions.d/limitgauge.fish", "share/limitgauge/result.schema.json",
        "share/limitgauge/probe.schema.json", "share/doc/limitgauge/docs/probe.md",
        "share/doc/limitgauge/README.md", "share/doc/limitgauge/LICENSE",
        "share/doc/limitgauge/docs/verifier.md", "share/doc/limitgauge/THIRD-PARTY.txt"}) {
    CAPTURE(file);
    CHECK(fs::is_regular_file(prefix / file));
    CHECK(fs::file_size(prefix / file) > 500);
  }
  const ShellOutcome links = bash("python3 '" + tests::fixtures().string() +
                                  "/../tests/docs/check_links.py' --installed '" +
                                  (prefix / "share/doc/limitgauge").string() + "'");
  INFO(links.out);
  CHECK(links.exit_code == 0);
  const std::string program = (prefix / "bin/limitgauge").string();
  const ShellOutcome version = bash(program + " --version");
  CHECK(version.exit_code == 0);
  CHECK_THAT(version.out, ContainsSubstring("limitgauge 0."));
  const ShellOutcome planned =
      bash("cd '" + scratch.path().string() + "' && " + program +
           " plan usr/share/doc/limitgauge/fixtures/jobs/quick-dome.toml -o paths");
  INFO(planned.out);
  CHECK(planned.exit_code == 0);
  CHECK(fs::exists(scratch / "paths/finish/toolpath.ngc"));
}

TEST_CASE("packages hold the program and the libraries, and say what they need", "[e2e][install]") {
  if (!is_installed("dpkg-shlibdeps") || !is_installed("file")) {
    WARN("dpkg-dev or file is not installed: no packages are made here");
    return;
  }
  const Scratch scratch;
  const fs::path cpack = fs::path(LIMITGAUGE_CMAKE).parent_path() / "cpack";
  const ShellOutcome packed =
      bash("cd '" + scratch.path().string() + "' && '" + cpack.string() +
           "' -G DEB -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip --config '" LIMITGAUGE_BUILD
           "/CPackConfig.cmake' -B . && mkdir both && " +
           "for package in *.deb; do dpkg-deb -x $package both; dpkg-deb -f $package; done");
  INFO(packed.out);
  REQUIRE(packed.exit_code == 0);
  for (const char* said : {"Package: limitgauge\n", "Package: liblimitgauge-dev\n", "libopenvdb",
                           "libopenvdb-dev", "Section: science"})
    CHECK_THAT(packed.out, ContainsSubstring(said));
  for (const char* file :
       {"bin/limitgauge", "share/man/man1/limitgauge.1.gz", "share/doc/limitgauge/copyright",
        "share/zsh/vendor-completions/_limitgauge", "share/doc/liblimitgauge-dev/copyright",
        "lib/cmake/Limitgauge/LimitgaugeConfig.cmake",
        "include/limitgauge/verifier/gate/verify.h"}) {
    CAPTURE(file);
    CHECK(fs::is_regular_file(scratch / "both/usr" / file));
  }
  const ShellOutcome version = bash((scratch / "both/usr/bin/limitgauge").string() + " --version");
  CHECK(version.exit_code == 0);
}

}  // namespace
}  // namespace limitgauge::e2e

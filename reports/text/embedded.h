#pragma once

#include <string_view>

/// Texts that are built into the program: schemas of reports/, reports/study and reports/probe,
/// styles of reports/html and reports/probe, and what the bundler makes of reports/web (see
/// reports/CMakeLists.txt).
namespace limitgauge::reports::embedded {

std::string_view result_schema();
std::string_view study_schema();
std::string_view probe_schema();
std::string_view report_css();
std::string_view tolerances_css();    ///< what it adds where tolerances are stated
std::string_view probe_css();         ///< what the page of measured points adds
std::string_view report_js();         ///< the page's script, bundled from reports/web
std::string_view report_js_sha256();  ///< its checksum in base64, for the page's policy
std::string_view script_css();        ///< the style of what the script adds
/// The like of a study's and of a history's page.
std::string_view study_js();
std::string_view study_js_sha256();
std::string_view study_css();
std::string_view history_js();
std::string_view history_js_sha256();
std::string_view history_css();

}  // namespace limitgauge::reports::embedded

struct type_6 {
member: array<u32>,
}
struct type_7 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: vec4<u32>,
}
struct type_8 {
member: type_7,
}
struct type_11 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(2)
var<storage, read_write> global_1: type_11;
@group(0) @binding(0)
var<storage> global_2: type_8;
@group(0) @binding(1)
var<storage> global_3: type_6;
fn function_() {
var local: i32;
var phi_113_: u32;
var phi_116_: u32;
var phi_118_: u32;
var phi_114_: u32;
var phi_117_: u32;
var phi_119_: u32;
var local_1: u32;
var local_2: u32;
var phi_152_: u32;
var phi_155_: u32;
var phi_157_: u32;
var phi_217_: u32;
var phi_218_: bool;
var phi_223_: u32;
var phi_226_: u32;
var phi_228_: u32;
var phi_230_: u32;
var phi_266_: i32;
var phi_280_: i32;
var phi_286_: i32;
var phi_297_: u32;
var phi_298_: u32;
var phi_299_: u32;
var phi_224_: u32;
var phi_227_: u32;
var phi_229_: u32;
var phi_231_: u32;
var phi_301_: u32;
var phi_302_: u32;
var phi_303_: u32;
var phi_153_: u32;
var phi_156_: u32;
var phi_158_: u32;
var local_3: u32;
var local_4: u32;
var local_5: u32;
let _e20 = global;
let _e25 = arrayLength((&global_1.member));
let _e29 = global_2.member.member[0u];
let _e33 = global_2.member.member[1u];
if (_e20.x < _e29) {
if (_e20.y < _e33) {
let _e41 = global_2.member.member[2u];
let _e43 = ((_e20.y * _e29) + _e20.x);
let _e47 = global_2.member.member_1[0u];
local = bitcast<i32>((_e43 * (_e47 + 1u)));
let _e54 = global_2.member.member[3u];
let _e56 = local;
let _e60 = local;
if (((_e43 < _e54) && (_e56 >= 0i)) && ((_e60 + bitcast<i32>(_e47)) < bitcast<i32>(arrayLength((&global_3.member))))) {
phi_113_ = 0u;
phi_116_ = 0u;
phi_118_ = 0u;
loop {
let _e66 = phi_113_;
let _e68 = phi_116_;
let _e70 = phi_118_;
local_1 = _e70;
local_2 = _e68;
let _e71 = (_e66 <= _e47);
if _e71 {
let _e72 = local;
let _e73 = bitcast<i32>(_e66);
let _e77 = global_3.member[bitcast<u32>((_e72 + _e73))];
let _e79 = local;
let _e83 = global_3.member[bitcast<u32>((_e79 + _e73))];
phi_114_ = (_e66 + 1u);
phi_117_ = (_e68 | _e83);
phi_119_ = (_e70 + _e77);
} else {
phi_114_ = u32();
phi_117_ = u32();
phi_119_ = u32();
}
let _e87 = phi_114_;
let _e89 = phi_117_;
let _e91 = phi_119_;
continue;
continuing {
phi_113_ = _e87;
phi_116_ = _e89;
phi_118_ = _e91;
break if !(_e71);
}
}
let _e94 = local_1;
if (_e94 == 0u) {
let _e97 = local_2;
if (_e97 == 0u) {
} else {
phi_152_ = 0u;
phi_155_ = 0u;
phi_157_ = 0u;
loop {
let _e100 = phi_152_;
let _e102 = phi_155_;
let _e104 = phi_157_;
let _e108 = global_2.member.member_1[3u];
let _e109 = (_e102 < _e108);
if _e109 {
let _e110 = (_e102 * 4u);
let _e111 = (_e110 + 3u);
if (_e111 < _e47) {
let _e113 = local;
let _e118 = global_3.member[bitcast<u32>((_e113 + bitcast<i32>(_e110)))];
let _e120 = local;
let _e125 = global_3.member[bitcast<u32>((_e120 + bitcast<i32>((_e110 + 1u))))];
let _e128 = local;
let _e133 = global_3.member[bitcast<u32>((_e128 + bitcast<i32>((_e110 + 2u))))];
let _e135 = local;
let _e140 = global_3.member[bitcast<u32>((_e135 + bitcast<i32>(_e111)))];
phi_217_ = (_e100 * 16843009u);
phi_218_ = select(true, false, ((((_e118 | _e125) | _e133) | _e140) == 0u));
} else {
phi_217_ = u32();
phi_218_ = true;
}
let _e146 = phi_217_;
let _e148 = phi_218_;
if _e148 {
phi_223_ = _e100;
phi_226_ = 0u;
phi_228_ = 0u;
phi_230_ = _e104;
loop {
let _e150 = phi_223_;
let _e152 = phi_226_;
let _e154 = phi_228_;
let _e156 = phi_230_;
local_3 = _e150;
local_4 = _e154;
local_5 = _e156;
let _e157 = (_e152 < 4u);
if _e157 {
let _e158 = (_e110 + _e152);
if (_e158 < _e47) {
let _e160 = local;
let _e165 = global_3.member[bitcast<u32>((_e160 + bitcast<i32>(_e158)))];
let _e166 = (_e156 + _e165);
let _e167 = bitcast<i32>(_e166);
let _e171 = global_2.member.member_2[3u];
let _e172 = (_e171 & 31u);
let _e174 = (1i << bitcast<u32>(_e172));
if (_e167 < 0i) {
phi_266_ = -(_e167);
} else {
phi_266_ = _e167;
}
let _e178 = phi_266_;
if (_e41 == 1u) {
let _e180 = (2i * _e174);
let _e182 = (_e178 & (_e180 - 1i));
if (_e182 > _e174) {
phi_280_ = (_e180 - _e182);
} else {
phi_280_ = _e182;
}
let _e186 = phi_280_;
phi_286_ = _e186;
} else {
phi_286_ = select(_e178, _e174, (_e178 > _e174));
}
let _e190 = phi_286_;
let _e197 = bitcast<u32>((((_e190 * 255i) + (_e174 >> bitcast<u32>(1i))) >> bitcast<u32>(_e172)));
phi_297_ = _e197;
phi_298_ = (_e154 | (_e197 << bitcast<u32>(((8u * _e152) & 31u))));
phi_299_ = _e166;
} else {
phi_297_ = _e150;
phi_298_ = _e154;
phi_299_ = _e156;
}
let _e204 = phi_297_;
let _e206 = phi_298_;
let _e208 = phi_299_;
phi_224_ = _e204;
phi_227_ = (_e152 + 1u);
phi_229_ = _e206;
phi_231_ = _e208;
} else {
phi_224_ = u32();
phi_227_ = u32();
phi_229_ = u32();
phi_231_ = u32();
}
let _e211 = phi_224_;
let _e213 = phi_227_;
let _e215 = phi_229_;
let _e217 = phi_231_;
continue;
continuing {
phi_223_ = _e211;
phi_226_ = _e213;
phi_228_ = _e215;
phi_230_ = _e217;
break if !(_e157);
}
}
let _e278 = local_3;
phi_301_ = _e278;
let _e281 = local_4;
phi_302_ = _e281;
let _e284 = local_5;
phi_303_ = _e284;
} else {
phi_301_ = _e100;
phi_302_ = _e146;
phi_303_ = _e104;
}
let _e220 = phi_301_;
let _e222 = phi_302_;
let _e224 = phi_303_;
if (_e222 == 0u) {
} else {
let _e227 = ((_e43 * _e108) + _e102);
if (_e227 < _e25) {
let _e231 = atomicAdd((&global_1.member[_e227]), _e222);
}
}
phi_153_ = _e220;
phi_156_ = (_e102 + 1u);
phi_158_ = _e224;
} else {
phi_153_ = u32();
phi_156_ = u32();
phi_158_ = u32();
}
let _e234 = phi_153_;
let _e236 = phi_156_;
let _e238 = phi_158_;
continue;
continuing {
phi_152_ = _e234;
phi_155_ = _e236;
phi_157_ = _e238;
break if !(_e109);
}
}
}
} else {
let _e243 = global_2.member.member_1[3u];
let _e244 = (_e54 * _e243);
if (_e244 < _e25) {
let _e248 = atomicAdd((&global_1.member[_e244]), 1u);
}
}
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}

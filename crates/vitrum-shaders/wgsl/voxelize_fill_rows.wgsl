struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_7 {
member: array<u32>,
}
struct type_8 {
member: type_2,
member_1: u32,
member_2: type_2,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: f32,
}
struct type_9 {
member: type_8,
}
struct type_12 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(2)
var<storage, read_write> global_1: type_12;
@group(0) @binding(0)
var<storage> global_2: type_9;
@group(0) @binding(1)
var<storage> global_3: type_7;
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
var phi_216_: u32;
var phi_217_: bool;
var phi_222_: u32;
var phi_225_: u32;
var phi_227_: u32;
var phi_229_: u32;
var phi_264_: i32;
var phi_278_: i32;
var phi_284_: i32;
var phi_295_: u32;
var phi_296_: u32;
var phi_297_: u32;
var phi_223_: u32;
var phi_226_: u32;
var phi_228_: u32;
var phi_230_: u32;
var phi_299_: u32;
var phi_300_: u32;
var phi_301_: u32;
var phi_153_: u32;
var phi_156_: u32;
var phi_158_: u32;
var local_3: u32;
var local_4: u32;
var local_5: u32;
let _e20 = global;
let _e25 = arrayLength((&global_1.member));
let _e28 = global_2.member.member;
if (_e20.x < _e28.member) {
if (_e20.y < _e28.member_1) {
let _e39 = global_2.member.member.member;
let _e41 = ((_e20.y * _e39) + _e20.x);
let _e45 = global_2.member.member_2.member;
local = bitcast<i32>((_e41 * (_e45 + 1u)));
let _e51 = global_2.member.member_1;
let _e53 = local;
let _e57 = local;
if (((_e41 < _e51) && (_e53 >= 0i)) && ((_e57 + bitcast<i32>(_e45)) < bitcast<i32>(arrayLength((&global_3.member))))) {
phi_113_ = 0u;
phi_116_ = 0u;
phi_118_ = 0u;
loop {
let _e63 = phi_113_;
let _e65 = phi_116_;
let _e67 = phi_118_;
local_1 = _e67;
local_2 = _e65;
let _e68 = (_e63 <= _e45);
if _e68 {
let _e69 = local;
let _e70 = bitcast<i32>(_e63);
let _e74 = global_3.member[bitcast<u32>((_e69 + _e70))];
let _e76 = local;
let _e80 = global_3.member[bitcast<u32>((_e76 + _e70))];
phi_114_ = (_e63 + 1u);
phi_117_ = (_e65 | _e80);
phi_119_ = (_e67 + _e74);
} else {
phi_114_ = u32();
phi_117_ = u32();
phi_119_ = u32();
}
let _e84 = phi_114_;
let _e86 = phi_117_;
let _e88 = phi_119_;
continue;
continuing {
phi_113_ = _e84;
phi_116_ = _e86;
phi_118_ = _e88;
break if !(_e68);
}
}
let _e91 = local_1;
if (_e91 == 0u) {
let _e94 = local_2;
if (_e94 == 0u) {
} else {
phi_152_ = 0u;
phi_155_ = 0u;
phi_157_ = 0u;
loop {
let _e97 = phi_152_;
let _e99 = phi_155_;
let _e101 = phi_157_;
let _e104 = global_2.member.member_3;
let _e105 = (_e99 < _e104);
if _e105 {
let _e106 = (_e99 * 4u);
let _e107 = (_e106 + 3u);
if (_e107 < _e45) {
let _e109 = local;
let _e114 = global_3.member[bitcast<u32>((_e109 + bitcast<i32>(_e106)))];
let _e116 = local;
let _e121 = global_3.member[bitcast<u32>((_e116 + bitcast<i32>((_e106 + 1u))))];
let _e124 = local;
let _e129 = global_3.member[bitcast<u32>((_e124 + bitcast<i32>((_e106 + 2u))))];
let _e131 = local;
let _e136 = global_3.member[bitcast<u32>((_e131 + bitcast<i32>(_e107)))];
phi_216_ = (_e97 * 16843009u);
phi_217_ = select(true, false, ((((_e114 | _e121) | _e129) | _e136) == 0u));
} else {
phi_216_ = u32();
phi_217_ = true;
}
let _e142 = phi_216_;
let _e144 = phi_217_;
if _e144 {
phi_222_ = _e97;
phi_225_ = 0u;
phi_227_ = 0u;
phi_229_ = _e101;
loop {
let _e146 = phi_222_;
let _e148 = phi_225_;
let _e150 = phi_227_;
let _e152 = phi_229_;
local_3 = _e146;
local_4 = _e150;
local_5 = _e152;
let _e153 = (_e148 < 4u);
if _e153 {
let _e154 = (_e106 + _e148);
if (_e154 < _e45) {
let _e156 = local;
let _e161 = global_3.member[bitcast<u32>((_e156 + bitcast<i32>(_e154)))];
let _e162 = (_e152 + _e161);
let _e163 = bitcast<i32>(_e162);
let _e166 = global_2.member.member_7;
let _e167 = (_e166 & 31u);
let _e169 = (1i << bitcast<u32>(_e167));
if (_e163 < 0i) {
phi_264_ = -(_e163);
} else {
phi_264_ = _e163;
}
let _e173 = phi_264_;
if (_e28.member_2 == 1u) {
let _e175 = (2i * _e169);
let _e177 = (_e173 & (_e175 - 1i));
if (_e177 > _e169) {
phi_278_ = (_e175 - _e177);
} else {
phi_278_ = _e177;
}
let _e181 = phi_278_;
phi_284_ = _e181;
} else {
phi_284_ = select(_e173, _e169, (_e173 > _e169));
}
let _e185 = phi_284_;
let _e192 = bitcast<u32>((((_e185 * 255i) + (_e169 >> bitcast<u32>(1i))) >> bitcast<u32>(_e167)));
phi_295_ = _e192;
phi_296_ = (_e150 | (_e192 << bitcast<u32>(((8u * _e148) & 31u))));
phi_297_ = _e162;
} else {
phi_295_ = _e146;
phi_296_ = _e150;
phi_297_ = _e152;
}
let _e199 = phi_295_;
let _e201 = phi_296_;
let _e203 = phi_297_;
phi_223_ = _e199;
phi_226_ = (_e148 + 1u);
phi_228_ = _e201;
phi_230_ = _e203;
} else {
phi_223_ = u32();
phi_226_ = u32();
phi_228_ = u32();
phi_230_ = u32();
}
let _e206 = phi_223_;
let _e208 = phi_226_;
let _e210 = phi_228_;
let _e212 = phi_230_;
continue;
continuing {
phi_222_ = _e206;
phi_225_ = _e208;
phi_227_ = _e210;
phi_229_ = _e212;
break if !(_e153);
}
}
let _e272 = local_3;
phi_299_ = _e272;
let _e275 = local_4;
phi_300_ = _e275;
let _e278 = local_5;
phi_301_ = _e278;
} else {
phi_299_ = _e97;
phi_300_ = _e142;
phi_301_ = _e101;
}
let _e215 = phi_299_;
let _e217 = phi_300_;
let _e219 = phi_301_;
if (_e217 == 0u) {
} else {
let _e222 = ((_e41 * _e104) + _e99);
if (_e222 < _e25) {
let _e226 = atomicAdd((&global_1.member[_e222]), _e217);
}
}
phi_153_ = _e215;
phi_156_ = (_e99 + 1u);
phi_158_ = _e219;
} else {
phi_153_ = u32();
phi_156_ = u32();
phi_158_ = u32();
}
let _e229 = phi_153_;
let _e231 = phi_156_;
let _e233 = phi_158_;
continue;
continuing {
phi_152_ = _e229;
phi_155_ = _e231;
phi_157_ = _e233;
break if !(_e105);
}
}
}
} else {
let _e237 = global_2.member.member_3;
let _e238 = (_e51 * _e237);
if (_e238 < _e25) {
let _e242 = atomicAdd((&global_1.member[_e238]), 1u);
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

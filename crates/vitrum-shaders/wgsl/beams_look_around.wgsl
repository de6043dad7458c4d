struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_10 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: f32,
member_4: u32,
member_5: u32,
member_6: u32,
}
struct type_11 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_10,
}
struct type_13 {
member: array<f32>,
}
struct type_15 {
member: u32,
member_1: u32,
}
struct type_16 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_17 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
}
struct type_18 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
}
struct type_19 {
member: f32,
member_1: u32,
}
struct type_20 {
member: type_2,
member_1: type_15,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_16,
member_12: type_17,
member_13: type_18,
member_14: type_9,
member_15: type_6,
member_16: type_5,
member_17: u32,
member_18: type_19,
}
struct type_21 {
member: type_20,
}
struct type_22 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_21;
@group(0) @binding(2)
var<storage, read_write> global_2: type_13;
@group(0) @binding(1)
var<storage> global_3: type_13;
fn function_() {
var phi_99_: u32;
var phi_115_: u32;
var phi_118_: u32;
var phi_116_: u32;
var phi_119_: u32;
var local: u32;
var phi_147_: u32;
var phi_150_: u32;
var local_1: u32;
var local_2: u32;
var phi_148_: u32;
var phi_151_: u32;
var local_3: u32;
var local_4: u32;
var local_5: u32;
var phi_190_: i32;
var phi_193_: type_22;
var phi_204_: i32;
var phi_207_: type_22;
var local_6: u32;
var phi_248_: u32;
var phi_251_: u32;
var local_7: u32;
var phi_249_: u32;
var phi_252_: u32;
var local_8: u32;
var phi_275_: u32;
var phi_278_: u32;
var local_9: u32;
var local_10: u32;
var phi_276_: u32;
var phi_279_: u32;
var local_11: u32;
var phi_374_: type_22;
var phi_205_: i32;
var phi_208_: type_22;
var phi_191_: i32;
var phi_194_: type_22;
var local_12: u32;
var phi_399_: u32;
var phi_402_: u32;
var local_13: u32;
var phi_400_: u32;
var phi_403_: u32;
var local_14: u32;
var phi_426_: u32;
var phi_429_: u32;
var local_15: u32;
var local_16: u32;
var phi_427_: u32;
var phi_430_: u32;
var local_17: u32;
var local_18: type_22;
var local_19: type_22;
var local_20: type_22;
var local_21: type_22;
let _e18 = global;
let _e20 = arrayLength((&global_3.member));
let _e23 = global_1.member.member;
if (_e18.x < _e23.member) {
if (_e18.y < _e23.member_1) {
let _e30 = (_e23.member * _e23.member_1);
let _e32 = ((_e18.y * _e23.member) + _e18.x);
phi_99_ = 1u;
loop {
let _e34 = phi_99_;
let _e38 = global_1.member.member_18.member_1;
let _e43 = global_1.member.member_1.member_1;
let _e44 = (_e34 + 1u);
phi_115_ = 1u;
phi_118_ = 0u;
local_1 = _e34;
local_2 = _e43;
local_4 = _e34;
local_5 = _e43;
local_6 = _e38;
local_7 = _e43;
local_9 = _e34;
local_10 = _e43;
local_12 = _e38;
local_13 = _e43;
local_15 = _e34;
local_16 = _e43;
loop {
let _e46 = phi_115_;
let _e48 = phi_118_;
local = _e48;
let _e49 = (_e46 < _e44);
if _e49 {
let _e50 = (_e46 & 31u);
phi_116_ = (_e46 + 1u);
phi_119_ = (_e48 + (((_e43 + (1u << bitcast<u32>(_e50))) - 1u) >> bitcast<u32>(_e50)));
} else {
phi_116_ = u32();
phi_119_ = u32();
}
let _e60 = phi_116_;
let _e62 = phi_119_;
continue;
continuing {
phi_115_ = _e60;
phi_118_ = _e62;
break if !(_e49);
}
}
let _e65 = local;
let _e67 = ((_e34 < _e38) && (_e18.y >= _e65));
continue;
continuing {
phi_99_ = select(u32(), _e44, _e67);
break if !(_e67);
}
}
let _e70 = bitcast<i32>(_e18.x);
phi_147_ = 1u;
phi_150_ = 0u;
loop {
let _e72 = phi_147_;
let _e74 = phi_150_;
local_3 = _e74;
let _e76 = local_1;
let _e77 = (_e72 < _e76);
if _e77 {
let _e78 = (_e72 & 31u);
let _e82 = local_2;
phi_148_ = (_e72 + 1u);
phi_151_ = (_e74 + (((_e82 + (1u << bitcast<u32>(_e78))) - 1u) >> bitcast<u32>(_e78)));
} else {
phi_148_ = u32();
phi_151_ = u32();
}
let _e90 = phi_148_;
let _e92 = phi_151_;
continue;
continuing {
phi_147_ = _e90;
phi_150_ = _e92;
break if !(_e77);
}
}
let _e95 = local_3;
let _e97 = bitcast<i32>((_e18.y - _e95));
let _e101 = global_1.member.member_1.member;
let _e103 = local_4;
let _e104 = (_e103 & 31u);
let _e106 = (1u << bitcast<u32>(_e104));
let _e112 = local_5;
phi_190_ = (_e97 - 2i);
phi_193_ = type_22(1e30f, 0f, 1e30f, 0f);
loop {
let _e121 = phi_190_;
let _e123 = phi_193_;
local_18 = _e123;
local_19 = _e123;
local_20 = _e123;
let _e125 = (_e121 <= (_e97 + 2i));
if _e125 {
phi_204_ = (_e70 - 2i);
phi_207_ = _e123;
loop {
let _e128 = phi_204_;
let _e130 = phi_207_;
local_21 = _e130;
let _e132 = (_e128 <= (_e70 + 2i));
if _e132 {
if ((((_e128 >= 0i) && (_e128 < bitcast<i32>((((_e101 + _e106) - 1u) >> bitcast<u32>(_e104))))) && (_e121 >= 0i)) && (_e121 < bitcast<i32>((((_e112 + _e106) - 1u) >> bitcast<u32>(_e104))))) {
let _e143 = bitcast<i32>(((_e101 + 1u) >> bitcast<u32>(1u)));
let _e145 = local_6;
phi_248_ = 1u;
phi_251_ = 0u;
loop {
let _e148 = phi_248_;
let _e150 = phi_251_;
local_8 = _e150;
let _e151 = (_e148 < (_e145 + 1u));
if _e151 {
let _e152 = (_e148 & 31u);
let _e156 = local_7;
phi_249_ = (_e148 + 1u);
phi_252_ = (_e150 + (((_e156 + (1u << bitcast<u32>(_e152))) - 1u) >> bitcast<u32>(_e152)));
} else {
phi_249_ = u32();
phi_252_ = u32();
}
let _e164 = phi_249_;
let _e166 = phi_252_;
continue;
continuing {
phi_248_ = _e164;
phi_251_ = _e166;
break if !(_e151);
}
}
let _e169 = local_8;
phi_275_ = 1u;
phi_278_ = 0u;
loop {
let _e173 = phi_275_;
let _e175 = phi_278_;
local_11 = _e175;
let _e177 = local_9;
let _e178 = (_e173 < _e177);
if _e178 {
let _e179 = (_e173 & 31u);
let _e183 = local_10;
phi_276_ = (_e173 + 1u);
phi_279_ = (_e175 + (((_e183 + (1u << bitcast<u32>(_e179))) - 1u) >> bitcast<u32>(_e179)));
} else {
phi_276_ = u32();
phi_279_ = u32();
}
let _e191 = phi_276_;
let _e193 = phi_279_;
continue;
continuing {
phi_275_ = _e191;
phi_278_ = _e193;
break if !(_e178);
}
}
let _e196 = local_11;
let _e200 = (((bitcast<i32>(_e196) + _e121) * _e143) + _e128);
let _e202 = (bitcast<i32>(_e20) - 1i);
let _e204 = select(_e202, _e200, (_e200 < _e202));
let _e210 = global_3.member[bitcast<u32>(select(0i, _e204, (_e204 > 0i)))];
let _e211 = ((_e143 * bitcast<i32>(_e169)) + _e200);
let _e213 = select(_e202, _e211, (_e211 < _e202));
let _e219 = global_3.member[bitcast<u32>(select(0i, _e213, (_e213 > 0i)))];
let _e230 = ((((_e128 >= (_e70 - 1i)) && (_e128 <= (_e70 + 1i))) && (_e121 >= (_e97 - 1i))) && (_e121 <= (_e97 + 1i)));
let _e237 = type_22(_e130.member, _e130.member_1, select(_e210, _e130.member_2, (_e130.member_2 < _e210)), _e130.member_3);
let _e239 = select(1e30f, _e210, _e230);
let _e245 = type_22(select(_e239, _e130.member, (_e130.member < _e239)), _e237.member_1, _e237.member_2, _e237.member_3);
let _e247 = select(0f, _e219, _e230);
phi_374_ = type_22(_e245.member, select(_e247, _e130.member_1, (_e130.member_1 > _e247)), _e245.member_2, _e245.member_3);
} else {
phi_374_ = _e130;
}
let _e255 = phi_374_;
phi_205_ = (_e128 + 1i);
phi_208_ = _e255;
} else {
phi_205_ = i32();
phi_208_ = type_22();
}
let _e258 = phi_205_;
let _e260 = phi_208_;
continue;
continuing {
phi_204_ = _e258;
phi_207_ = _e260;
break if !(_e132);
}
}
phi_191_ = (_e121 + 1i);
let _e402 = local_21;
phi_194_ = _e402;
} else {
phi_191_ = i32();
phi_194_ = type_22();
}
let _e264 = phi_191_;
let _e266 = phi_194_;
continue;
continuing {
phi_190_ = _e264;
phi_193_ = _e266;
break if !(_e125);
}
}
let _e271 = bitcast<i32>(((_e101 + 1u) >> bitcast<u32>(1u)));
let _e273 = local_12;
phi_399_ = 1u;
phi_402_ = 0u;
loop {
let _e276 = phi_399_;
let _e278 = phi_402_;
local_14 = _e278;
let _e279 = (_e276 < (_e273 + 1u));
if _e279 {
let _e280 = (_e276 & 31u);
let _e284 = local_13;
phi_400_ = (_e276 + 1u);
phi_403_ = (_e278 + (((_e284 + (1u << bitcast<u32>(_e280))) - 1u) >> bitcast<u32>(_e280)));
} else {
phi_400_ = u32();
phi_403_ = u32();
}
let _e292 = phi_400_;
let _e294 = phi_403_;
continue;
continuing {
phi_399_ = _e292;
phi_402_ = _e294;
break if !(_e279);
}
}
let _e297 = local_14;
phi_426_ = 1u;
phi_429_ = 0u;
loop {
let _e301 = phi_426_;
let _e303 = phi_429_;
local_17 = _e303;
let _e305 = local_15;
let _e306 = (_e301 < _e305);
if _e306 {
let _e307 = (_e301 & 31u);
let _e311 = local_16;
phi_427_ = (_e301 + 1u);
phi_430_ = (_e303 + (((_e311 + (1u << bitcast<u32>(_e307))) - 1u) >> bitcast<u32>(_e307)));
} else {
phi_427_ = u32();
phi_430_ = u32();
}
let _e319 = phi_427_;
let _e321 = phi_430_;
continue;
continuing {
phi_426_ = _e319;
phi_429_ = _e321;
break if !(_e306);
}
}
let _e324 = local_17;
let _e330 = ((2i * (_e271 * bitcast<i32>(_e297))) + (((bitcast<i32>(_e324) + _e97) * _e271) + _e70));
let _e332 = (bitcast<i32>(_e20) - 1i);
let _e334 = select(_e332, _e330, (_e330 < _e332));
let _e340 = global_3.member[bitcast<u32>(select(0i, _e334, (_e334 > 0i)))];
let _e342 = local_18;
let _e345 = local_19;
let _e348 = local_20;
global_2.member[_e32] = _e342.member;
global_2.member[(_e30 + _e32)] = _e345.member_1;
global_2.member[((2u * _e30) + _e32)] = _e348.member_2;
global_2.member[((3u * _e30) + _e32)] = _e340;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}

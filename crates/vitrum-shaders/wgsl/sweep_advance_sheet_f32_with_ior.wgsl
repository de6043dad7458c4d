struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
}
struct type_6 {
member: array<f32>,
}
struct type_11 {
member: array<u32>,
}
struct type_13 {
member: type_4,
member_1: type_4,
member_2: type_4,
member_3: type_4,
member_4: type_4,
member_5: vec4<i32>,
member_6: vec4<i32>,
member_7: vec4<i32>,
}
struct type_14 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: vec4<u32>,
member_4: type_4,
member_5: type_13,
member_6: type_13,
member_7: type_4,
member_8: type_4,
member_9: type_4,
member_10: type_4,
member_11: type_4,
member_12: type_4,
member_13: type_4,
member_14: type_4,
member_15: type_4,
member_16: type_4,
member_17: type_4,
member_18: type_4,
member_19: type_4,
member_20: type_4,
member_21: type_4,
member_22: type_4,
member_23: type_4,
member_24: type_4,
member_25: vec4<u32>,
member_26: type_4,
member_27: type_4,
member_28: type_4,
member_29: type_4,
member_30: type_4,
member_31: type_4,
}
struct type_15 {
member: type_14,
}
struct type_18 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_19 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_20 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
struct type_21 {
member: f32,
member_1: f32,
member_2: f32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_15;
@group(0) @binding(1)
var<storage> global_2: type_11;
@group(0) @binding(3)
var<storage> global_3: type_11;
@group(0) @binding(4)
var<storage> global_4: type_11;
@group(0) @binding(5)
var<storage> global_5: type_6;
@group(0) @binding(6)
var<storage, read_write> global_6: type_6;
@group(0) @binding(2)
var<storage> global_7: type_11;
fn function_() {
var local: type_18;
var local_1: vec3<f32>;
var local_2: type_18;
var local_3: vec3<f32>;
var local_4: type_18;
var local_5: vec3<f32>;
var local_6: type_18;
var local_7: vec3<f32>;
var phi_9856_: type_19;
var phi_11176_: type_20;
var phi_12697_: type_21;
var phi_13721_: f32;
var phi_13722_: f32;
var phi_13723_: f32;
var phi_13724_: bool;
switch bitcast<i32>(0u) {
default: {
let _e88 = global;
let _e91 = arrayLength((&global_2.member));
let _e98 = arrayLength((&global_4.member));
let _e105 = global_1.member.member_1;
let _e108 = (_e88.x + _e105.x);
let _e111 = (_e88.y + _e105.y);
if (_e108 < _e105.z) {
if (_e111 < _e105.w) {
let _e119 = global_1.member.member[0u];
let _e123 = global_1.member.member[1u];
let _e124 = (_e119 * _e123);
let _e126 = ((_e111 * _e119) + _e108);
let _e127 = bitcast<i32>(_e126);
let _e129 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e131 = select(_e129, _e127, (_e127 < _e129));
let _e137 = global_6.member[bitcast<u32>(select(0i, _e131, (_e131 > 0i)))];
let _e138 = (_e124 + _e126);
let _e139 = bitcast<i32>(_e138);
let _e141 = select(_e129, _e139, (_e139 < _e129));
let _e147 = global_6.member[bitcast<u32>(select(0i, _e141, (_e141 > 0i)))];
let _e149 = ((2u * _e124) + _e126);
let _e150 = bitcast<i32>(_e149);
let _e152 = select(_e129, _e150, (_e150 < _e129));
let _e158 = global_6.member[bitcast<u32>(select(0i, _e152, (_e152 > 0i)))];
let _e160 = ((3u * _e124) + _e126);
let _e161 = bitcast<i32>(_e160);
let _e163 = select(_e129, _e161, (_e161 < _e129));
let _e169 = global_6.member[bitcast<u32>(select(0i, _e163, (_e163 > 0i)))];
let _e171 = ((4u * _e124) + _e126);
let _e172 = bitcast<i32>(_e171);
let _e174 = select(_e129, _e172, (_e172 < _e129));
let _e180 = global_6.member[bitcast<u32>(select(0i, _e174, (_e174 > 0i)))];
let _e182 = ((5u * _e124) + _e126);
let _e183 = bitcast<i32>(_e182);
let _e185 = select(_e129, _e183, (_e183 < _e129));
let _e191 = global_6.member[bitcast<u32>(select(0i, _e185, (_e185 > 0i)))];
let _e193 = ((6u * _e124) + _e126);
let _e194 = bitcast<i32>(_e193);
let _e196 = select(_e129, _e194, (_e194 < _e129));
let _e202 = global_6.member[bitcast<u32>(select(0i, _e196, (_e196 > 0i)))];
let _e204 = ((7u * _e124) + _e126);
let _e205 = bitcast<i32>(_e204);
let _e207 = select(_e129, _e205, (_e205 < _e129));
let _e213 = global_6.member[bitcast<u32>(select(0i, _e207, (_e207 > 0i)))];
let _e215 = ((8u * _e124) + _e126);
let _e216 = bitcast<i32>(_e215);
let _e218 = select(_e129, _e216, (_e216 < _e129));
let _e224 = global_6.member[bitcast<u32>(select(0i, _e218, (_e218 > 0i)))];
let _e226 = ((9u * _e124) + _e126);
let _e227 = bitcast<i32>(_e226);
let _e229 = select(_e129, _e227, (_e227 < _e129));
let _e235 = global_6.member[bitcast<u32>(select(0i, _e229, (_e229 > 0i)))];
let _e237 = ((10u * _e124) + _e126);
let _e238 = bitcast<i32>(_e237);
let _e240 = select(_e129, _e238, (_e238 < _e129));
let _e246 = global_6.member[bitcast<u32>(select(0i, _e240, (_e240 > 0i)))];
let _e250 = global_1.member.member_4.member_2;
let _e253 = (1f / select(1e-6f, _e202, (_e202 > 1e-6f)));
let _e257 = global_1.member.member_7.member_3;
let _e258 = (_e250 * _e257);
let _e263 = global_1.member.member_8.member;
let _e265 = (((_e180 * _e253) - _e263) * _e258);
let _e270 = global_1.member.member_8.member_1;
let _e272 = (((_e191 * _e253) - _e270) * _e258);
let _e276 = ((f32(bitcast<i32>(_e108)) - 0.5f) + _e137);
let _e280 = global_1.member.member_2[3u];
let _e281 = (_e280 + 1u);
let _e283 = select(1u, _e281, (_e281 > 0u));
let _e284 = (_e283 == 0u);
if _e284 {
break;
}
let _e289 = ((f32(bitcast<i32>((_e111 % _e283))) - 0.5f) + _e147);
let _e293 = global_1.member.member_4.member;
let _e297 = global_1.member.member_8.member_2;
let _e298 = (_e293 - _e297);
let _e302 = global_1.member.member_7.member;
let _e309 = global_1.member.member_7.member_2;
let _e311 = ((_e302 + (_e263 * _e298)) + ((_e276 + 0.5f) * _e309));
let _e315 = global_1.member.member_7.member_1;
let _e320 = ((_e315 + (_e270 * _e298)) + ((_e289 + 0.5f) * _e309));
let _e326 = global_1.member.member_4.member_1;
let _e327 = (_e326 - _e297);
let _e332 = ((_e302 + (_e263 * _e327)) + (((_e276 + _e265) + 0.5f) * _e309));
let _e337 = ((_e315 + (_e270 * _e327)) + (((_e289 + _e272) + 0.5f) * _e309));
if _e284 {
break;
}
let _e340 = bitcast<i32>(((_e111 / _e283) * 3u));
let _e342 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e344 = select(_e342, _e340, (_e340 < _e342));
let _e350 = global_5.member[bitcast<u32>(select(0i, _e344, (_e344 > 0i)))];
let _e351 = (_e340 + 1i);
let _e353 = select(_e342, _e351, (_e351 < _e342));
let _e359 = global_5.member[bitcast<u32>(select(0i, _e353, (_e353 > 0i)))];
let _e360 = (_e340 + 2i);
let _e362 = select(_e342, _e360, (_e360 < _e342));
let _e368 = global_5.member[bitcast<u32>(select(0i, _e362, (_e362 > 0i)))];
let _e371 = (1f / select(1e-6f, _e368, (_e368 > 1e-6f)));
let _e374 = (((_e350 * _e371) - _e263) * _e258);
let _e377 = (((_e359 * _e371) - _e270) * _e258);
let _e389 = global_1.member.member_5.member;
let _e402 = global_1.member.member_5.member.member_3;
let _e403 = ((((_e389.member * _e311) + (_e389.member_1 * _e320)) + (_e389.member_2 * _e293)) + _e402);
let _e407 = global_1.member.member_5.member_1;
let _e420 = global_1.member.member_5.member_1.member_3;
let _e421 = ((((_e407.member * _e311) + (_e407.member_1 * _e320)) + (_e407.member_2 * _e293)) + _e420);
let _e425 = global_1.member.member_5.member_2;
let _e438 = global_1.member.member_5.member_2.member_3;
let _e439 = ((((_e425.member * _e311) + (_e425.member_1 * _e320)) + (_e425.member_2 * _e293)) + _e438);
let _e445 = ((((_e389.member * _e332) + (_e389.member_1 * _e337)) + (_e389.member_2 * _e326)) + _e402);
let _e451 = ((((_e407.member * _e332) + (_e407.member_1 * _e337)) + (_e407.member_2 * _e326)) + _e420);
let _e457 = ((((_e425.member * _e332) + (_e425.member_1 * _e337)) + (_e425.member_2 * _e326)) + _e438);
let _e462 = global_1.member.member_5.member_3.member_3;
let _e467 = global_1.member.member_5.member_3.member;
let _e468 = (_e467 - 0.5f);
let _e470 = select(-0.5f, _e445, (_e445 > -0.5f));
let _e472 = select(_e468, _e470, (_e470 < _e468));
let _e477 = global_1.member.member_5.member_3.member_1;
let _e478 = (_e477 - 0.5f);
let _e480 = select(-0.5f, _e451, (_e451 > -0.5f));
let _e482 = select(_e478, _e480, (_e480 < _e478));
let _e487 = global_1.member.member_5.member_3.member_2;
let _e488 = (_e487 - 0.5f);
let _e490 = select(-0.5f, _e457, (_e457 > -0.5f));
let _e492 = select(_e488, _e490, (_e490 < _e488));
let _e493 = (_e445 - _e403);
let _e494 = (_e451 - _e421);
let _e495 = (_e457 - _e439);
let _e498 = bitcast<f32>((bitcast<u32>(_e493) & 2147483647u));
let _e501 = bitcast<f32>((bitcast<u32>(_e494) & 2147483647u));
let _e503 = select(_e501, _e498, (_e498 > _e501));
let _e506 = bitcast<f32>((bitcast<u32>(_e495) & 2147483647u));
let _e515 = bitcast<f32>((bitcast<u32>((_e445 - _e472)) & 2147483647u));
let _e518 = bitcast<f32>((bitcast<u32>((_e451 - _e482)) & 2147483647u));
let _e520 = select(_e518, _e515, (_e515 > _e518));
let _e523 = bitcast<f32>((bitcast<u32>((_e457 - _e492)) & 2147483647u));
let _e527 = (_e472 + 0.5f);
let _e528 = (_e467 - 1f);
let _e530 = select(0f, _e527, (_e527 > 0f));
let _e532 = select(_e528, _e530, (_e530 < _e528));
let _e539 = select(0i, select(select(i32(_e532), i32(-2147483648), (_e532 < -2147483600f)), 2147483647i, (_e532 > 2147483500f)), (_e532 == _e532));
let _e548 = global_1.member.member_5.member_7[3u];
let _e549 = (_e548 & 31i);
let _e552 = (_e482 + 0.5f);
let _e553 = (_e477 - 1f);
let _e555 = select(0f, _e552, (_e552 > 0f));
let _e557 = select(_e553, _e555, (_e555 < _e553));
let _e564 = select(0i, select(select(i32(_e557), i32(-2147483648), (_e557 < -2147483600f)), 2147483647i, (_e557 > 2147483500f)), (_e557 == _e557));
let _e571 = (_e492 + 0.5f);
let _e572 = (_e487 - 1f);
let _e574 = select(0f, _e571, (_e571 > 0f));
let _e576 = select(_e572, _e574, (_e574 < _e572));
let _e583 = select(0i, select(select(i32(_e576), i32(-2147483648), (_e576 < -2147483600f)), 2147483647i, (_e576 > 2147483500f)), (_e576 == _e576));
let _e594 = global_1.member.member_5.member_6[3u];
let _e600 = global_1.member.member_5.member_6[0u];
let _e605 = global_1.member.member_5.member_6[1u];
let _e609 = ((_e594 + ((_e539 - select(0i, 1i, (_e532 < f32(_e539)))) >> bitcast<u32>(_e549))) + (_e600 * (((_e564 - select(0i, 1i, (_e557 < f32(_e564)))) >> bitcast<u32>(_e549)) + (_e605 * ((_e583 - select(0i, 1i, (_e576 < f32(_e583)))) >> bitcast<u32>(_e549))))));
let _e611 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e613 = select(_e611, _e609, (_e609 < _e611));
let _e619 = global_3.member[bitcast<u32>(select(0i, _e613, (_e613 > 0i)))];
let _e626 = global_1.member.member_6.member;
let _e639 = global_1.member.member_6.member.member_3;
let _e644 = global_1.member.member_6.member_1;
let _e657 = global_1.member.member_6.member_1.member_3;
let _e662 = global_1.member.member_6.member_2;
let _e675 = global_1.member.member_6.member_2.member_3;
let _e682 = ((((_e626.member * _e332) + (_e626.member_1 * _e337)) + (_e626.member_2 * _e326)) + _e639);
let _e688 = ((((_e644.member * _e332) + (_e644.member_1 * _e337)) + (_e644.member_2 * _e326)) + _e657);
let _e694 = ((((_e662.member * _e332) + (_e662.member_1 * _e337)) + (_e662.member_2 * _e326)) + _e675);
let _e699 = global_1.member.member_6.member_3.member_3;
let _e704 = global_1.member.member_6.member_3.member;
let _e705 = (_e704 - 0.5f);
let _e707 = select(-0.5f, _e682, (_e682 > -0.5f));
let _e709 = select(_e705, _e707, (_e707 < _e705));
let _e714 = global_1.member.member_6.member_3.member_1;
let _e715 = (_e714 - 0.5f);
let _e717 = select(-0.5f, _e688, (_e688 > -0.5f));
let _e719 = select(_e715, _e717, (_e717 < _e715));
let _e724 = global_1.member.member_6.member_3.member_2;
let _e725 = (_e724 - 0.5f);
let _e727 = select(-0.5f, _e694, (_e694 > -0.5f));
let _e729 = select(_e725, _e727, (_e727 < _e725));
let _e735 = bitcast<f32>((bitcast<u32>((_e682 - ((((_e626.member * _e311) + (_e626.member_1 * _e320)) + (_e626.member_2 * _e293)) + _e639))) & 2147483647u));
let _e738 = bitcast<f32>((bitcast<u32>((_e688 - ((((_e644.member * _e311) + (_e644.member_1 * _e320)) + (_e644.member_2 * _e293)) + _e657))) & 2147483647u));
let _e740 = select(_e738, _e735, (_e735 > _e738));
let _e743 = bitcast<f32>((bitcast<u32>((_e694 - ((((_e662.member * _e311) + (_e662.member_1 * _e320)) + (_e662.member_2 * _e293)) + _e675))) & 2147483647u));
let _e752 = bitcast<f32>((bitcast<u32>((_e682 - _e709)) & 2147483647u));
let _e755 = bitcast<f32>((bitcast<u32>((_e688 - _e719)) & 2147483647u));
let _e757 = select(_e755, _e752, (_e752 > _e755));
let _e760 = bitcast<f32>((bitcast<u32>((_e694 - _e729)) & 2147483647u));
let _e764 = (_e709 + 0.5f);
let _e765 = (_e704 - 1f);
let _e767 = select(0f, _e764, (_e764 > 0f));
let _e769 = select(_e765, _e767, (_e767 < _e765));
let _e776 = select(0i, select(select(i32(_e769), i32(-2147483648), (_e769 < -2147483600f)), 2147483647i, (_e769 > 2147483500f)), (_e769 == _e769));
let _e785 = global_1.member.member_6.member_7[3u];
let _e786 = (_e785 & 31i);
let _e789 = (_e719 + 0.5f);
let _e790 = (_e714 - 1f);
let _e792 = select(0f, _e789, (_e789 > 0f));
let _e794 = select(_e790, _e792, (_e792 < _e790));
let _e801 = select(0i, select(select(i32(_e794), i32(-2147483648), (_e794 < -2147483600f)), 2147483647i, (_e794 > 2147483500f)), (_e794 == _e794));
let _e808 = (_e729 + 0.5f);
let _e809 = (_e724 - 1f);
let _e811 = select(0f, _e808, (_e808 > 0f));
let _e813 = select(_e809, _e811, (_e811 < _e809));
let _e820 = select(0i, select(select(i32(_e813), i32(-2147483648), (_e813 < -2147483600f)), 2147483647i, (_e813 > 2147483500f)), (_e813 == _e813));
let _e831 = global_1.member.member_6.member_6[3u];
let _e837 = global_1.member.member_6.member_6[0u];
let _e842 = global_1.member.member_6.member_6[1u];
let _e846 = ((_e831 + ((_e776 - select(0i, 1i, (_e769 < f32(_e776)))) >> bitcast<u32>(_e786))) + (_e837 * (((_e801 - select(0i, 1i, (_e794 < f32(_e801)))) >> bitcast<u32>(_e786)) + (_e842 * ((_e820 - select(0i, 1i, (_e813 < f32(_e820)))) >> bitcast<u32>(_e786))))));
let _e848 = select(_e611, _e846, (_e846 < _e611));
let _e854 = global_3.member[bitcast<u32>(select(0i, _e848, (_e848 > 0i)))];
let _e861 = global_1.member.member[3u];
let _e868 = (((_e861 & 64u) != 0u) || ((((select(_e506, _e503, (_e503 > _e506)) <= _e462) && ((select(_e523, _e520, (_e520 > _e523)) > _e462) || (_e619 != 0u))) && ((select(_e743, _e740, (_e740 > _e743)) <= _e699) && ((select(_e760, _e757, (_e757 > _e760)) > _e699) || (_e854 != 0u)))) && ((_e861 & 32u) != 0u)));
if (select(0u, select(7u, select(3u, 1u, ((((_e265 == 0f) && (_e272 == 0f)) && (_e374 == 0f)) && (_e377 == 0f))), _e868), (_e246 == 0f)) > 1u) {
let _e876 = global_1.member.member[2u];
if _e284 {
break;
}
if _e284 {
break;
}
let _e878 = (_e876 == 2u);
let _e881 = (((_e876 == 1u) || _e878) || (_e876 == 5u));
if _e881 {
let _e1134 = select(-1f, _e472, (_e472 > -1f));
let _e1136 = select(_e467, _e1134, (_e1134 < _e467));
let _e1143 = select(0i, select(select(i32(_e1136), i32(-2147483648), (_e1136 < -2147483600f)), 2147483647i, (_e1136 > 2147483500f)), (_e1136 == _e1136));
let _e1147 = (_e1143 - select(0i, 1i, (_e1136 < f32(_e1143))));
let _e1149 = select(-1f, _e482, (_e482 > -1f));
let _e1151 = select(_e477, _e1149, (_e1149 < _e477));
let _e1158 = select(0i, select(select(i32(_e1151), i32(-2147483648), (_e1151 < -2147483600f)), 2147483647i, (_e1151 > 2147483500f)), (_e1151 == _e1151));
let _e1162 = (_e1158 - select(0i, 1i, (_e1151 < f32(_e1158))));
let _e1164 = select(-1f, _e492, (_e492 > -1f));
let _e1166 = select(_e487, _e1164, (_e1164 < _e487));
let _e1173 = select(0i, select(select(i32(_e1166), i32(-2147483648), (_e1166 < -2147483600f)), 2147483647i, (_e1166 > 2147483500f)), (_e1166 == _e1166));
let _e1177 = (_e1173 - select(0i, 1i, (_e1166 < f32(_e1173))));
let _e1182 = global_1.member.member_5.member_5[0u];
let _e1187 = global_1.member.member_5.member_5[1u];
let _e1195 = (select(0i, select(select(i32(_e477), i32(-2147483648), (_e477 < -2147483600f)), 2147483647i, (_e477 > 2147483500f)), (_e477 == _e477)) - 1i);
let _e1198 = (_e1162 + 1i);
let _e1208 = (select(0i, select(select(i32(_e487), i32(-2147483648), (_e487 < -2147483600f)), 2147483647i, (_e487 > 2147483500f)), (_e487 == _e487)) - 1i);
let _e1211 = (_e1177 + 1i);
let _e1221 = (select(0i, select(select(i32(_e467), i32(-2147483648), (_e467 < -2147483600f)), 2147483647i, (_e467 > 2147483500f)), (_e467 == _e467)) - 1i);
let _e1222 = (_e1147 - 1i);
let _e1227 = (_e1147 + 1i);
let _e1230 = (_e1147 + 2i);
let _e1233 = (select(0i, _e1162, (_e1162 > 0i)) * _e1182);
let _e1234 = (select(_e1195, _e1198, (_e1198 < _e1195)) * _e1182);
let _e1235 = (select(0i, _e1177, (_e1177 > 0i)) * _e1187);
let _e1236 = (select(_e1208, _e1211, (_e1211 < _e1208)) * _e1187);
local_6 = type_18(array<i32, 4>(select(0i, _e1222, (_e1222 > 0i)), select(0i, _e1147, (_e1147 > 0i)), select(_e1221, _e1227, (_e1227 < _e1221)), select(_e1221, _e1230, (_e1230 < _e1221))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_7 = vec3<f32>((_e472 - f32(_e1147)), (_e482 - f32(_e1162)), (_e492 - f32(_e1177)));
let _e1247 = (_e1235 + _e1233);
let _e1249 = (bitcast<i32>(_e91) - 1i);
let _e1252 = local_6.member[1u];
let _e1253 = (_e1247 + _e1252);
let _e1255 = select(_e1249, _e1253, (_e1253 < _e1249));
let _e1260 = global_2.member[bitcast<u32>(select(0i, _e1255, (_e1255 > 0i)))];
let _e1261 = bitcast<f32>(_e1260);
let _e1264 = local_6.member[2u];
let _e1265 = (_e1247 + _e1264);
let _e1267 = select(_e1249, _e1265, (_e1265 < _e1249));
let _e1272 = global_2.member[bitcast<u32>(select(0i, _e1267, (_e1267 > 0i)))];
let _e1274 = local_7[0u];
let _e1277 = (_e1261 + ((bitcast<f32>(_e1272) - _e1261) * _e1274));
let _e1278 = (_e1235 + _e1234);
let _e1279 = local_6.member[1u];
let _e1280 = (_e1278 + _e1279);
let _e1282 = select(_e1249, _e1280, (_e1280 < _e1249));
let _e1287 = global_2.member[bitcast<u32>(select(0i, _e1282, (_e1282 > 0i)))];
let _e1288 = bitcast<f32>(_e1287);
let _e1289 = local_6.member[2u];
let _e1290 = (_e1278 + _e1289);
let _e1292 = select(_e1249, _e1290, (_e1290 < _e1249));
let _e1297 = global_2.member[bitcast<u32>(select(0i, _e1292, (_e1292 > 0i)))];
let _e1299 = local_7[0u];
let _e1303 = (_e1236 + _e1233);
let _e1304 = local_6.member[1u];
let _e1305 = (_e1303 + _e1304);
let _e1307 = select(_e1249, _e1305, (_e1305 < _e1249));
let _e1312 = global_2.member[bitcast<u32>(select(0i, _e1307, (_e1307 > 0i)))];
let _e1313 = bitcast<f32>(_e1312);
let _e1314 = local_6.member[2u];
let _e1315 = (_e1303 + _e1314);
let _e1317 = select(_e1249, _e1315, (_e1315 < _e1249));
let _e1322 = global_2.member[bitcast<u32>(select(0i, _e1317, (_e1317 > 0i)))];
let _e1324 = local_7[0u];
let _e1327 = (_e1313 + ((bitcast<f32>(_e1322) - _e1313) * _e1324));
let _e1328 = (_e1236 + _e1234);
let _e1329 = local_6.member[1u];
let _e1330 = (_e1328 + _e1329);
let _e1332 = select(_e1249, _e1330, (_e1330 < _e1249));
let _e1337 = global_2.member[bitcast<u32>(select(0i, _e1332, (_e1332 > 0i)))];
let _e1338 = bitcast<f32>(_e1337);
let _e1339 = local_6.member[2u];
let _e1340 = (_e1328 + _e1339);
let _e1342 = select(_e1249, _e1340, (_e1340 < _e1249));
let _e1347 = global_2.member[bitcast<u32>(select(0i, _e1342, (_e1342 > 0i)))];
let _e1349 = local_7[0u];
let _e1354 = local_7[1u];
let _e1357 = (_e1277 + (((_e1288 + ((bitcast<f32>(_e1297) - _e1288) * _e1299)) - _e1277) * _e1354));
let _e1358 = local_7[1u];
let _e1363 = local_7[2u];
let _e1371 = global_1.member.member_5.member_4.member;
let _e1377 = global_1.member.member_5.member_4.member_1;
let _e1378 = (((_e1357 + (((_e1327 + (((_e1338 + ((bitcast<f32>(_e1347) - _e1338) * _e1349)) - _e1327) * _e1358)) - _e1357) * _e1363)) * _e1371) + _e1377);
let _e1380 = select(0f, _e1378, (_e1378 > 0f));
let _e1384 = select(-1f, _e709, (_e709 > -1f));
let _e1386 = select(_e704, _e1384, (_e1384 < _e704));
let _e1393 = select(0i, select(select(i32(_e1386), i32(-2147483648), (_e1386 < -2147483600f)), 2147483647i, (_e1386 > 2147483500f)), (_e1386 == _e1386));
let _e1397 = (_e1393 - select(0i, 1i, (_e1386 < f32(_e1393))));
let _e1399 = select(-1f, _e719, (_e719 > -1f));
let _e1401 = select(_e714, _e1399, (_e1399 < _e714));
let _e1408 = select(0i, select(select(i32(_e1401), i32(-2147483648), (_e1401 < -2147483600f)), 2147483647i, (_e1401 > 2147483500f)), (_e1401 == _e1401));
let _e1412 = (_e1408 - select(0i, 1i, (_e1401 < f32(_e1408))));
let _e1414 = select(-1f, _e729, (_e729 > -1f));
let _e1416 = select(_e724, _e1414, (_e1414 < _e724));
let _e1423 = select(0i, select(select(i32(_e1416), i32(-2147483648), (_e1416 < -2147483600f)), 2147483647i, (_e1416 > 2147483500f)), (_e1416 == _e1416));
let _e1427 = (_e1423 - select(0i, 1i, (_e1416 < f32(_e1423))));
let _e1432 = global_1.member.member_6.member_5[0u];
let _e1437 = global_1.member.member_6.member_5[1u];
let _e1445 = (select(0i, select(select(i32(_e714), i32(-2147483648), (_e714 < -2147483600f)), 2147483647i, (_e714 > 2147483500f)), (_e714 == _e714)) - 1i);
let _e1446 = (_e1412 - 1i);
let _e1451 = (_e1412 + 1i);
let _e1454 = (_e1412 + 2i);
let _e1464 = (select(0i, select(select(i32(_e724), i32(-2147483648), (_e724 < -2147483600f)), 2147483647i, (_e724 > 2147483500f)), (_e724 == _e724)) - 1i);
let _e1465 = (_e1427 - 1i);
let _e1470 = (_e1427 + 1i);
let _e1473 = (_e1427 + 2i);
let _e1483 = (select(0i, select(select(i32(_e704), i32(-2147483648), (_e704 < -2147483600f)), 2147483647i, (_e704 > 2147483500f)), (_e704 == _e704)) - 1i);
let _e1484 = (_e1397 - 1i);
let _e1489 = (_e1397 + 1i);
let _e1492 = (_e1397 + 2i);
let _e1495 = (select(0i, _e1446, (_e1446 > 0i)) * _e1432);
let _e1496 = (select(0i, _e1412, (_e1412 > 0i)) * _e1432);
let _e1497 = (select(_e1445, _e1451, (_e1451 < _e1445)) * _e1432);
let _e1498 = (select(_e1445, _e1454, (_e1454 < _e1445)) * _e1432);
let _e1499 = (select(0i, _e1465, (_e1465 > 0i)) * _e1437);
let _e1500 = (select(0i, _e1427, (_e1427 > 0i)) * _e1437);
let _e1501 = (select(_e1464, _e1470, (_e1470 < _e1464)) * _e1437);
let _e1502 = (select(_e1464, _e1473, (_e1473 < _e1464)) * _e1437);
local_4 = type_18(array<i32, 4>(select(0i, _e1484, (_e1484 > 0i)), select(0i, _e1397, (_e1397 > 0i)), select(_e1483, _e1489, (_e1489 < _e1483)), select(_e1483, _e1492, (_e1492 < _e1483))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_5 = vec3<f32>((_e709 - f32(_e1397)), (_e719 - f32(_e1412)), (_e729 - f32(_e1427)));
let _e1513 = (_e1500 + _e1496);
let _e1516 = local_4.member[0u];
let _e1517 = (_e1513 + _e1516);
let _e1519 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e1521 = select(_e1519, _e1517, (_e1517 < _e1519));
let _e1526 = global_7.member[bitcast<u32>(select(0i, _e1521, (_e1521 > 0i)))];
let _e1527 = bitcast<f32>(_e1526);
let _e1530 = local_4.member[1u];
let _e1531 = (_e1513 + _e1530);
let _e1533 = select(_e1519, _e1531, (_e1531 < _e1519));
let _e1538 = global_7.member[bitcast<u32>(select(0i, _e1533, (_e1533 > 0i)))];
let _e1539 = bitcast<f32>(_e1538);
let _e1542 = local_4.member[2u];
let _e1543 = (_e1513 + _e1542);
let _e1545 = select(_e1519, _e1543, (_e1543 < _e1519));
let _e1550 = global_7.member[bitcast<u32>(select(0i, _e1545, (_e1545 > 0i)))];
let _e1551 = bitcast<f32>(_e1550);
let _e1554 = local_4.member[3u];
let _e1555 = (_e1513 + _e1554);
let _e1557 = select(_e1519, _e1555, (_e1555 < _e1519));
let _e1562 = global_7.member[bitcast<u32>(select(0i, _e1557, (_e1557 > 0i)))];
let _e1564 = local_5[0u];
let _e1567 = (_e1527 + ((_e1539 - _e1527) * _e1564));
let _e1568 = local_5[0u];
let _e1571 = (_e1539 + ((_e1551 - _e1539) * _e1568));
let _e1572 = local_5[0u];
let _e1575 = (_e1551 + ((bitcast<f32>(_e1562) - _e1551) * _e1572));
let _e1576 = (_e1500 + _e1497);
let _e1577 = local_4.member[0u];
let _e1578 = (_e1576 + _e1577);
let _e1580 = select(_e1519, _e1578, (_e1578 < _e1519));
let _e1585 = global_7.member[bitcast<u32>(select(0i, _e1580, (_e1580 > 0i)))];
let _e1586 = bitcast<f32>(_e1585);
let _e1587 = local_4.member[1u];
let _e1588 = (_e1576 + _e1587);
let _e1590 = select(_e1519, _e1588, (_e1588 < _e1519));
let _e1595 = global_7.member[bitcast<u32>(select(0i, _e1590, (_e1590 > 0i)))];
let _e1596 = bitcast<f32>(_e1595);
let _e1597 = local_4.member[2u];
let _e1598 = (_e1576 + _e1597);
let _e1600 = select(_e1519, _e1598, (_e1598 < _e1519));
let _e1605 = global_7.member[bitcast<u32>(select(0i, _e1600, (_e1600 > 0i)))];
let _e1606 = bitcast<f32>(_e1605);
let _e1607 = local_4.member[3u];
let _e1608 = (_e1576 + _e1607);
let _e1610 = select(_e1519, _e1608, (_e1608 < _e1519));
let _e1615 = global_7.member[bitcast<u32>(select(0i, _e1610, (_e1610 > 0i)))];
let _e1617 = local_5[0u];
let _e1621 = local_5[0u];
let _e1624 = (_e1596 + ((_e1606 - _e1596) * _e1621));
let _e1625 = local_5[0u];
let _e1629 = (_e1501 + _e1496);
let _e1630 = local_4.member[0u];
let _e1631 = (_e1629 + _e1630);
let _e1633 = select(_e1519, _e1631, (_e1631 < _e1519));
let _e1638 = global_7.member[bitcast<u32>(select(0i, _e1633, (_e1633 > 0i)))];
let _e1639 = bitcast<f32>(_e1638);
let _e1640 = local_4.member[1u];
let _e1641 = (_e1629 + _e1640);
let _e1643 = select(_e1519, _e1641, (_e1641 < _e1519));
let _e1648 = global_7.member[bitcast<u32>(select(0i, _e1643, (_e1643 > 0i)))];
let _e1649 = bitcast<f32>(_e1648);
let _e1650 = local_4.member[2u];
let _e1651 = (_e1629 + _e1650);
let _e1653 = select(_e1519, _e1651, (_e1651 < _e1519));
let _e1658 = global_7.member[bitcast<u32>(select(0i, _e1653, (_e1653 > 0i)))];
let _e1659 = bitcast<f32>(_e1658);
let _e1660 = local_4.member[3u];
let _e1661 = (_e1629 + _e1660);
let _e1663 = select(_e1519, _e1661, (_e1661 < _e1519));
let _e1668 = global_7.member[bitcast<u32>(select(0i, _e1663, (_e1663 > 0i)))];
let _e1670 = local_5[0u];
let _e1673 = (_e1639 + ((_e1649 - _e1639) * _e1670));
let _e1674 = local_5[0u];
let _e1677 = (_e1649 + ((_e1659 - _e1649) * _e1674));
let _e1678 = local_5[0u];
let _e1681 = (_e1659 + ((bitcast<f32>(_e1668) - _e1659) * _e1678));
let _e1682 = (_e1501 + _e1497);
let _e1683 = local_4.member[0u];
let _e1684 = (_e1682 + _e1683);
let _e1686 = select(_e1519, _e1684, (_e1684 < _e1519));
let _e1691 = global_7.member[bitcast<u32>(select(0i, _e1686, (_e1686 > 0i)))];
let _e1692 = bitcast<f32>(_e1691);
let _e1693 = local_4.member[1u];
let _e1694 = (_e1682 + _e1693);
let _e1696 = select(_e1519, _e1694, (_e1694 < _e1519));
let _e1701 = global_7.member[bitcast<u32>(select(0i, _e1696, (_e1696 > 0i)))];
let _e1702 = bitcast<f32>(_e1701);
let _e1703 = local_4.member[2u];
let _e1704 = (_e1682 + _e1703);
let _e1706 = select(_e1519, _e1704, (_e1704 < _e1519));
let _e1711 = global_7.member[bitcast<u32>(select(0i, _e1706, (_e1706 > 0i)))];
let _e1712 = bitcast<f32>(_e1711);
let _e1713 = local_4.member[3u];
let _e1714 = (_e1682 + _e1713);
let _e1716 = select(_e1519, _e1714, (_e1714 < _e1519));
let _e1721 = global_7.member[bitcast<u32>(select(0i, _e1716, (_e1716 > 0i)))];
let _e1723 = local_5[0u];
let _e1727 = local_5[0u];
let _e1730 = (_e1702 + ((_e1712 - _e1702) * _e1727));
let _e1731 = local_5[0u];
let _e1735 = (_e1500 + _e1495);
let _e1736 = local_4.member[1u];
let _e1737 = (_e1735 + _e1736);
let _e1739 = select(_e1519, _e1737, (_e1737 < _e1519));
let _e1744 = global_7.member[bitcast<u32>(select(0i, _e1739, (_e1739 > 0i)))];
let _e1745 = bitcast<f32>(_e1744);
let _e1746 = local_4.member[2u];
let _e1747 = (_e1735 + _e1746);
let _e1749 = select(_e1519, _e1747, (_e1747 < _e1519));
let _e1754 = global_7.member[bitcast<u32>(select(0i, _e1749, (_e1749 > 0i)))];
let _e1756 = local_5[0u];
let _e1759 = (_e1745 + ((bitcast<f32>(_e1754) - _e1745) * _e1756));
let _e1760 = (_e1500 + _e1498);
let _e1761 = local_4.member[1u];
let _e1762 = (_e1760 + _e1761);
let _e1764 = select(_e1519, _e1762, (_e1762 < _e1519));
let _e1769 = global_7.member[bitcast<u32>(select(0i, _e1764, (_e1764 > 0i)))];
let _e1770 = bitcast<f32>(_e1769);
let _e1771 = local_4.member[2u];
let _e1772 = (_e1760 + _e1771);
let _e1774 = select(_e1519, _e1772, (_e1772 < _e1519));
let _e1779 = global_7.member[bitcast<u32>(select(0i, _e1774, (_e1774 > 0i)))];
let _e1781 = local_5[0u];
let _e1785 = (_e1501 + _e1495);
let _e1786 = local_4.member[1u];
let _e1787 = (_e1785 + _e1786);
let _e1789 = select(_e1519, _e1787, (_e1787 < _e1519));
let _e1794 = global_7.member[bitcast<u32>(select(0i, _e1789, (_e1789 > 0i)))];
let _e1795 = bitcast<f32>(_e1794);
let _e1796 = local_4.member[2u];
let _e1797 = (_e1785 + _e1796);
let _e1799 = select(_e1519, _e1797, (_e1797 < _e1519));
let _e1804 = global_7.member[bitcast<u32>(select(0i, _e1799, (_e1799 > 0i)))];
let _e1806 = local_5[0u];
let _e1809 = (_e1795 + ((bitcast<f32>(_e1804) - _e1795) * _e1806));
let _e1810 = (_e1501 + _e1498);
let _e1811 = local_4.member[1u];
let _e1812 = (_e1810 + _e1811);
let _e1814 = select(_e1519, _e1812, (_e1812 < _e1519));
let _e1819 = global_7.member[bitcast<u32>(select(0i, _e1814, (_e1814 > 0i)))];
let _e1820 = bitcast<f32>(_e1819);
let _e1821 = local_4.member[2u];
let _e1822 = (_e1810 + _e1821);
let _e1824 = select(_e1519, _e1822, (_e1822 < _e1519));
let _e1829 = global_7.member[bitcast<u32>(select(0i, _e1824, (_e1824 > 0i)))];
let _e1831 = local_5[0u];
let _e1835 = (_e1499 + _e1496);
let _e1836 = local_4.member[1u];
let _e1837 = (_e1835 + _e1836);
let _e1839 = select(_e1519, _e1837, (_e1837 < _e1519));
let _e1844 = global_7.member[bitcast<u32>(select(0i, _e1839, (_e1839 > 0i)))];
let _e1845 = bitcast<f32>(_e1844);
let _e1846 = local_4.member[2u];
let _e1847 = (_e1835 + _e1846);
let _e1849 = select(_e1519, _e1847, (_e1847 < _e1519));
let _e1854 = global_7.member[bitcast<u32>(select(0i, _e1849, (_e1849 > 0i)))];
let _e1856 = local_5[0u];
let _e1859 = (_e1845 + ((bitcast<f32>(_e1854) - _e1845) * _e1856));
let _e1860 = (_e1502 + _e1496);
let _e1861 = local_4.member[1u];
let _e1862 = (_e1860 + _e1861);
let _e1864 = select(_e1519, _e1862, (_e1862 < _e1519));
let _e1869 = global_7.member[bitcast<u32>(select(0i, _e1864, (_e1864 > 0i)))];
let _e1870 = bitcast<f32>(_e1869);
let _e1871 = local_4.member[2u];
let _e1872 = (_e1860 + _e1871);
let _e1874 = select(_e1519, _e1872, (_e1872 < _e1519));
let _e1879 = global_7.member[bitcast<u32>(select(0i, _e1874, (_e1874 > 0i)))];
let _e1881 = local_5[0u];
let _e1884 = (_e1870 + ((bitcast<f32>(_e1879) - _e1870) * _e1881));
let _e1885 = (_e1499 + _e1497);
let _e1886 = local_4.member[1u];
let _e1887 = (_e1885 + _e1886);
let _e1889 = select(_e1519, _e1887, (_e1887 < _e1519));
let _e1894 = global_7.member[bitcast<u32>(select(0i, _e1889, (_e1889 > 0i)))];
let _e1895 = bitcast<f32>(_e1894);
let _e1896 = local_4.member[2u];
let _e1897 = (_e1885 + _e1896);
let _e1899 = select(_e1519, _e1897, (_e1897 < _e1519));
let _e1904 = global_7.member[bitcast<u32>(select(0i, _e1899, (_e1899 > 0i)))];
let _e1906 = local_5[0u];
let _e1910 = (_e1502 + _e1497);
let _e1911 = local_4.member[1u];
let _e1912 = (_e1910 + _e1911);
let _e1914 = select(_e1519, _e1912, (_e1912 < _e1519));
let _e1919 = global_7.member[bitcast<u32>(select(0i, _e1914, (_e1914 > 0i)))];
let _e1920 = bitcast<f32>(_e1919);
let _e1921 = local_4.member[2u];
let _e1922 = (_e1910 + _e1921);
let _e1924 = select(_e1519, _e1922, (_e1922 < _e1519));
let _e1929 = global_7.member[bitcast<u32>(select(0i, _e1924, (_e1924 > 0i)))];
let _e1931 = local_5[0u];
let _e1936 = local_5[1u];
let _e1939 = (_e1571 + ((_e1624 - _e1571) * _e1936));
let _e1940 = local_5[1u];
let _e1943 = (_e1677 + ((_e1730 - _e1677) * _e1940));
let _e1944 = local_5[1u];
let _e1947 = (_e1567 + (((_e1586 + ((_e1596 - _e1586) * _e1617)) - _e1567) * _e1944));
let _e1948 = local_5[1u];
let _e1953 = local_5[2u];
let _e1957 = local_5[1u];
let _e1960 = (_e1575 + (((_e1606 + ((bitcast<f32>(_e1615) - _e1606) * _e1625)) - _e1575) * _e1957));
let _e1961 = local_5[1u];
let _e1965 = local_5[2u];
let _e1969 = local_5[1u];
let _e1972 = (_e1759 + ((_e1571 - _e1759) * _e1969));
let _e1973 = local_5[1u];
let _e1977 = local_5[2u];
let _e1981 = local_5[1u];
let _e1984 = (_e1624 + (((_e1770 + ((bitcast<f32>(_e1779) - _e1770) * _e1781)) - _e1624) * _e1981));
let _e1985 = local_5[1u];
let _e1989 = local_5[2u];
let _e1993 = local_5[1u];
let _e1996 = (_e1859 + (((_e1895 + ((bitcast<f32>(_e1904) - _e1895) * _e1906)) - _e1859) * _e1993));
let _e1997 = local_5[2u];
let _e2001 = local_5[1u];
let _e2005 = local_5[2u];
let _e2009 = local_5[2u];
let _e2017 = global_1.member.member_6.member_4.member;
let _e2023 = global_1.member.member_6.member_4.member_1;
let _e2024 = (((_e1939 + ((_e1943 - _e1939) * _e2009)) * _e2017) + _e2023);
let _e2026 = select(0f, _e2024, (_e2024 > 0f));
let _e2030 = (((_e1947 + (((_e1673 + (((_e1692 + ((_e1702 - _e1692) * _e1723)) - _e1673) * _e1948)) - _e1947) * _e1953)) * _e2017) + _e2023);
let _e2032 = select(0f, _e2030, (_e2030 > 0f));
let _e2034 = select(1f, _e2032, (_e2032 < 1f));
let _e2036 = (((_e1960 + (((_e1681 + (((_e1712 + ((bitcast<f32>(_e1721) - _e1712) * _e1731)) - _e1681) * _e1961)) - _e1960) * _e1965)) * _e2017) + _e2023);
let _e2038 = select(0f, _e2036, (_e2036 > 0f));
let _e2040 = select(1f, _e2038, (_e2038 < 1f));
let _e2042 = (((_e1972 + (((_e1809 + ((_e1677 - _e1809) * _e1973)) - _e1972) * _e1977)) * _e2017) + _e2023);
let _e2044 = select(0f, _e2042, (_e2042 > 0f));
let _e2046 = select(1f, _e2044, (_e2044 < 1f));
let _e2048 = (((_e1984 + (((_e1730 + (((_e1820 + ((bitcast<f32>(_e1829) - _e1820) * _e1831)) - _e1730) * _e1985)) - _e1984) * _e1989)) * _e2017) + _e2023);
let _e2050 = select(0f, _e2048, (_e2048 > 0f));
let _e2052 = select(1f, _e2050, (_e2050 < 1f));
let _e2054 = (((_e1996 + ((_e1939 - _e1996) * _e1997)) * _e2017) + _e2023);
let _e2056 = select(0f, _e2054, (_e2054 > 0f));
let _e2058 = select(1f, _e2056, (_e2056 < 1f));
let _e2060 = (((_e1943 + (((_e1884 + (((_e1920 + ((bitcast<f32>(_e1929) - _e1920) * _e1931)) - _e1884) * _e2001)) - _e1943) * _e2005)) * _e2017) + _e2023);
let _e2062 = select(0f, _e2060, (_e2060 > 0f));
let _e2064 = select(1f, _e2062, (_e2062 < 1f));
let _e2065 = (select(1f, _e2026, (_e2026 < 1f)) * 1024f);
let _e2066 = (1024f - 1f);
let _e2068 = select(0f, _e2065, (_e2065 > 0f));
let _e2070 = select(_e2066, _e2068, (_e2068 < _e2066));
let _e2077 = select(0i, select(select(i32(_e2070), i32(-2147483648), (_e2070 < -2147483600f)), 2147483647i, (_e2070 > 2147483500f)), (_e2070 == _e2070));
let _e2081 = (_e2077 - select(0i, 1i, (_e2070 < f32(_e2077))));
let _e2082 = (262147i + _e2081);
let _e2084 = (bitcast<i32>(_e98) - 1i);
let _e2086 = select(_e2084, _e2082, (_e2082 < _e2084));
let _e2092 = global_4.member[bitcast<u32>(select(0i, _e2086, (_e2086 > 0i)))];
let _e2102 = select(_e2084, 262146i, (262146i < _e2084));
let _e2108 = global_4.member[bitcast<u32>(select(0i, _e2102, (_e2102 > 0i)))];
let _e2109 = bitcast<f32>(_e2108);
let _e2110 = (f32((bitcast<i32>((_e2092 & 4095u)) - 2048i)) * _e2109);
let _e2112 = select(_e2084, 262144i, (262144i < _e2084));
let _e2118 = global_4.member[bitcast<u32>(select(0i, _e2112, (_e2112 > 0i)))];
let _e2119 = bitcast<f32>(_e2118);
let _e2121 = select(_e2084, 262145i, (262145i < _e2084));
let _e2127 = global_4.member[bitcast<u32>(select(0i, _e2121, (_e2121 > 0i)))];
let _e2128 = bitcast<f32>(_e2127);
let _e2134 = ((_e2119 + (f32(bitcast<i32>((_e2092 >> bitcast<u32>(12u)))) * _e2128)) + (_e2110 * (_e2065 - f32(_e2081))));
let _e2135 = (_e2110 * 1024f);
if _e878 {
let _e2400 = ((0.5f * (_e2040 - _e2034)) * _e2135);
let _e2401 = ((0.5f * (_e2052 - _e2046)) * _e2135);
let _e2402 = ((0.5f * (_e2064 - _e2058)) * _e2135);
phi_9856_ = type_19(_e2134, vec3<f32>(_e2400, _e2401, _e2402), vec3<f32>((_e2400 * _e2134), (_e2401 * _e2134), (_e2402 * _e2134)));
} else {
let _e2136 = (_e2034 * 1024f);
let _e2138 = select(0f, _e2136, (_e2136 > 0f));
let _e2140 = select(_e2066, _e2138, (_e2138 < _e2066));
let _e2147 = select(0i, select(select(i32(_e2140), i32(-2147483648), (_e2140 < -2147483600f)), 2147483647i, (_e2140 > 2147483500f)), (_e2140 == _e2140));
let _e2151 = (_e2147 - select(0i, 1i, (_e2140 < f32(_e2147))));
let _e2152 = (262147i + _e2151);
let _e2154 = select(_e2084, _e2152, (_e2152 < _e2084));
let _e2160 = global_4.member[bitcast<u32>(select(0i, _e2154, (_e2154 > 0i)))];
let _e2175 = ((_e2119 + (f32(bitcast<i32>((_e2160 >> bitcast<u32>(12u)))) * _e2128)) + ((f32((bitcast<i32>((_e2160 & 4095u)) - 2048i)) * _e2109) * (_e2136 - f32(_e2151))));
let _e2176 = (_e2040 * 1024f);
let _e2178 = select(0f, _e2176, (_e2176 > 0f));
let _e2180 = select(_e2066, _e2178, (_e2178 < _e2066));
let _e2187 = select(0i, select(select(i32(_e2180), i32(-2147483648), (_e2180 < -2147483600f)), 2147483647i, (_e2180 > 2147483500f)), (_e2180 == _e2180));
let _e2191 = (_e2187 - select(0i, 1i, (_e2180 < f32(_e2187))));
let _e2192 = (262147i + _e2191);
let _e2194 = select(_e2084, _e2192, (_e2192 < _e2084));
let _e2200 = global_4.member[bitcast<u32>(select(0i, _e2194, (_e2194 > 0i)))];
let _e2215 = ((_e2119 + (f32(bitcast<i32>((_e2200 >> bitcast<u32>(12u)))) * _e2128)) + ((f32((bitcast<i32>((_e2200 & 4095u)) - 2048i)) * _e2109) * (_e2176 - f32(_e2191))));
let _e2216 = (_e2046 * 1024f);
let _e2218 = select(0f, _e2216, (_e2216 > 0f));
let _e2220 = select(_e2066, _e2218, (_e2218 < _e2066));
let _e2227 = select(0i, select(select(i32(_e2220), i32(-2147483648), (_e2220 < -2147483600f)), 2147483647i, (_e2220 > 2147483500f)), (_e2220 == _e2220));
let _e2231 = (_e2227 - select(0i, 1i, (_e2220 < f32(_e2227))));
let _e2232 = (262147i + _e2231);
let _e2234 = select(_e2084, _e2232, (_e2232 < _e2084));
let _e2240 = global_4.member[bitcast<u32>(select(0i, _e2234, (_e2234 > 0i)))];
let _e2255 = ((_e2119 + (f32(bitcast<i32>((_e2240 >> bitcast<u32>(12u)))) * _e2128)) + ((f32((bitcast<i32>((_e2240 & 4095u)) - 2048i)) * _e2109) * (_e2216 - f32(_e2231))));
let _e2256 = (_e2052 * 1024f);
let _e2258 = select(0f, _e2256, (_e2256 > 0f));
let _e2260 = select(_e2066, _e2258, (_e2258 < _e2066));
let _e2267 = select(0i, select(select(i32(_e2260), i32(-2147483648), (_e2260 < -2147483600f)), 2147483647i, (_e2260 > 2147483500f)), (_e2260 == _e2260));
let _e2271 = (_e2267 - select(0i, 1i, (_e2260 < f32(_e2267))));
let _e2272 = (262147i + _e2271);
let _e2274 = select(_e2084, _e2272, (_e2272 < _e2084));
let _e2280 = global_4.member[bitcast<u32>(select(0i, _e2274, (_e2274 > 0i)))];
let _e2295 = ((_e2119 + (f32(bitcast<i32>((_e2280 >> bitcast<u32>(12u)))) * _e2128)) + ((f32((bitcast<i32>((_e2280 & 4095u)) - 2048i)) * _e2109) * (_e2256 - f32(_e2271))));
let _e2296 = (_e2058 * 1024f);
let _e2298 = select(0f, _e2296, (_e2296 > 0f));
let _e2300 = select(_e2066, _e2298, (_e2298 < _e2066));
let _e2307 = select(0i, select(select(i32(_e2300), i32(-2147483648), (_e2300 < -2147483600f)), 2147483647i, (_e2300 > 2147483500f)), (_e2300 == _e2300));
let _e2311 = (_e2307 - select(0i, 1i, (_e2300 < f32(_e2307))));
let _e2312 = (262147i + _e2311);
let _e2314 = select(_e2084, _e2312, (_e2312 < _e2084));
let _e2320 = global_4.member[bitcast<u32>(select(0i, _e2314, (_e2314 > 0i)))];
let _e2335 = ((_e2119 + (f32(bitcast<i32>((_e2320 >> bitcast<u32>(12u)))) * _e2128)) + ((f32((bitcast<i32>((_e2320 & 4095u)) - 2048i)) * _e2109) * (_e2296 - f32(_e2311))));
let _e2336 = (_e2064 * 1024f);
let _e2338 = select(0f, _e2336, (_e2336 > 0f));
let _e2340 = select(_e2066, _e2338, (_e2338 < _e2066));
let _e2347 = select(0i, select(select(i32(_e2340), i32(-2147483648), (_e2340 < -2147483600f)), 2147483647i, (_e2340 > 2147483500f)), (_e2340 == _e2340));
let _e2351 = (_e2347 - select(0i, 1i, (_e2340 < f32(_e2347))));
let _e2352 = (262147i + _e2351);
let _e2354 = select(_e2084, _e2352, (_e2352 < _e2084));
let _e2360 = global_4.member[bitcast<u32>(select(0i, _e2354, (_e2354 > 0i)))];
let _e2375 = ((_e2119 + (f32(bitcast<i32>((_e2360 >> bitcast<u32>(12u)))) * _e2128)) + ((f32((bitcast<i32>((_e2360 & 4095u)) - 2048i)) * _e2109) * (_e2336 - f32(_e2351))));
let _e2376 = (_e2215 - _e2175);
let _e2378 = (_e2295 - _e2255);
let _e2380 = (_e2375 - _e2335);
phi_9856_ = type_19(_e2134, vec3<f32>((0.5f * _e2376), (0.5f * _e2378), (0.5f * _e2380)), vec3<f32>((0.25f * (_e2376 * (_e2215 + _e2175))), (0.25f * (_e2378 * (_e2295 + _e2255))), (0.25f * (_e2380 * (_e2375 + _e2335)))));
}
let _e2410 = phi_9856_;
let _e2425 = select(0f, 1f, ((((((_e682 >= -0.5f) && (_e682 <= _e705)) && (_e688 >= -0.5f)) && (_e688 <= _e715)) && (_e694 >= -0.5f)) && (_e694 <= _e725)));
let _e2427 = (0.5f * (_e2040 - _e2034));
let _e2429 = (0.5f * (_e2052 - _e2046));
let _e2431 = (0.5f * (_e2064 - _e2058));
let _e2436 = global_1.member.member_6.member.member;
let _e2442 = global_1.member.member_6.member_1.member;
let _e2449 = global_1.member.member_6.member_2.member;
let _e2456 = global_1.member.member_6.member.member_1;
let _e2462 = global_1.member.member_6.member_1.member_1;
let _e2469 = global_1.member.member_6.member_2.member_1;
let _e2476 = global_1.member.member_6.member.member_2;
let _e2482 = global_1.member.member_6.member_1.member_2;
let _e2489 = global_1.member.member_6.member_2.member_2;
phi_11176_ = type_20(select(1f, _e1380, (_e1380 < 1f)), vec3<f32>(((((_e2436 * _e2427) + (_e2442 * _e2429)) + (_e2449 * _e2431)) * _e2425), ((((_e2456 * _e2427) + (_e2462 * _e2429)) + (_e2469 * _e2431)) * _e2425), ((((_e2476 * _e2427) + (_e2482 * _e2429)) + (_e2489 * _e2431)) * _e2425)), _e2410.member, vec3<f32>(((((_e2436 * _e2410.member_2.x) + (_e2442 * _e2410.member_2.y)) + (_e2449 * _e2410.member_2.z)) * _e2425), ((((_e2456 * _e2410.member_2.x) + (_e2462 * _e2410.member_2.y)) + (_e2469 * _e2410.member_2.z)) * _e2425), ((((_e2476 * _e2410.member_2.x) + (_e2482 * _e2410.member_2.y)) + (_e2489 * _e2410.member_2.z)) * _e2425)), vec3<f32>(((((_e2436 * _e2410.member_1.x) + (_e2442 * _e2410.member_1.y)) + (_e2449 * _e2410.member_1.z)) * _e2425), ((((_e2456 * _e2410.member_1.x) + (_e2462 * _e2410.member_1.y)) + (_e2469 * _e2410.member_1.z)) * _e2425), ((((_e2476 * _e2410.member_1.x) + (_e2482 * _e2410.member_1.y)) + (_e2489 * _e2410.member_1.z)) * _e2425)));
} else {
let _e883 = select(-1f, _e472, (_e472 > -1f));
let _e885 = select(_e467, _e883, (_e883 < _e467));
let _e892 = select(0i, select(select(i32(_e885), i32(-2147483648), (_e885 < -2147483600f)), 2147483647i, (_e885 > 2147483500f)), (_e885 == _e885));
let _e896 = (_e892 - select(0i, 1i, (_e885 < f32(_e892))));
let _e898 = select(-1f, _e482, (_e482 > -1f));
let _e900 = select(_e477, _e898, (_e898 < _e477));
let _e907 = select(0i, select(select(i32(_e900), i32(-2147483648), (_e900 < -2147483600f)), 2147483647i, (_e900 > 2147483500f)), (_e900 == _e900));
let _e911 = (_e907 - select(0i, 1i, (_e900 < f32(_e907))));
let _e913 = select(-1f, _e492, (_e492 > -1f));
let _e915 = select(_e487, _e913, (_e913 < _e487));
let _e922 = select(0i, select(select(i32(_e915), i32(-2147483648), (_e915 < -2147483600f)), 2147483647i, (_e915 > 2147483500f)), (_e915 == _e915));
let _e926 = (_e922 - select(0i, 1i, (_e915 < f32(_e922))));
let _e931 = global_1.member.member_5.member_5[0u];
let _e936 = global_1.member.member_5.member_5[1u];
let _e944 = (select(0i, select(select(i32(_e477), i32(-2147483648), (_e477 < -2147483600f)), 2147483647i, (_e477 > 2147483500f)), (_e477 == _e477)) - 1i);
let _e947 = (_e911 + 1i);
let _e957 = (select(0i, select(select(i32(_e487), i32(-2147483648), (_e487 < -2147483600f)), 2147483647i, (_e487 > 2147483500f)), (_e487 == _e487)) - 1i);
let _e960 = (_e926 + 1i);
let _e970 = (select(0i, select(select(i32(_e467), i32(-2147483648), (_e467 < -2147483600f)), 2147483647i, (_e467 > 2147483500f)), (_e467 == _e467)) - 1i);
let _e971 = (_e896 - 1i);
let _e976 = (_e896 + 1i);
let _e979 = (_e896 + 2i);
let _e982 = (select(0i, _e911, (_e911 > 0i)) * _e931);
let _e983 = (select(_e944, _e947, (_e947 < _e944)) * _e931);
let _e984 = (select(0i, _e926, (_e926 > 0i)) * _e936);
let _e985 = (select(_e957, _e960, (_e960 < _e957)) * _e936);
local_2 = type_18(array<i32, 4>(select(0i, _e971, (_e971 > 0i)), select(0i, _e896, (_e896 > 0i)), select(_e970, _e976, (_e976 < _e970)), select(_e970, _e979, (_e979 < _e970))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_3 = vec3<f32>((_e472 - f32(_e896)), (_e482 - f32(_e911)), (_e492 - f32(_e926)));
let _e996 = (_e984 + _e982);
let _e999 = local_2.member[1u];
let _e1000 = (_e996 + _e999);
let _e1002 = (bitcast<i32>(_e91) - 1i);
let _e1004 = select(_e1002, _e1000, (_e1000 < _e1002));
let _e1009 = global_2.member[bitcast<u32>(select(0i, _e1004, (_e1004 > 0i)))];
let _e1010 = bitcast<f32>(_e1009);
let _e1013 = local_2.member[2u];
let _e1014 = (_e996 + _e1013);
let _e1016 = select(_e1002, _e1014, (_e1014 < _e1002));
let _e1021 = global_2.member[bitcast<u32>(select(0i, _e1016, (_e1016 > 0i)))];
let _e1023 = local_3[0u];
let _e1026 = (_e1010 + ((bitcast<f32>(_e1021) - _e1010) * _e1023));
let _e1027 = (_e984 + _e983);
let _e1028 = local_2.member[1u];
let _e1029 = (_e1027 + _e1028);
let _e1031 = select(_e1002, _e1029, (_e1029 < _e1002));
let _e1036 = global_2.member[bitcast<u32>(select(0i, _e1031, (_e1031 > 0i)))];
let _e1037 = bitcast<f32>(_e1036);
let _e1038 = local_2.member[2u];
let _e1039 = (_e1027 + _e1038);
let _e1041 = select(_e1002, _e1039, (_e1039 < _e1002));
let _e1046 = global_2.member[bitcast<u32>(select(0i, _e1041, (_e1041 > 0i)))];
let _e1048 = local_3[0u];
let _e1053 = local_3[1u];
let _e1056 = (_e1026 + (((_e1037 + ((bitcast<f32>(_e1046) - _e1037) * _e1048)) - _e1026) * _e1053));
let _e1057 = (_e985 + _e982);
let _e1058 = local_2.member[1u];
let _e1059 = (_e1057 + _e1058);
let _e1061 = select(_e1002, _e1059, (_e1059 < _e1002));
let _e1066 = global_2.member[bitcast<u32>(select(0i, _e1061, (_e1061 > 0i)))];
let _e1067 = bitcast<f32>(_e1066);
let _e1068 = local_2.member[2u];
let _e1069 = (_e1057 + _e1068);
let _e1071 = select(_e1002, _e1069, (_e1069 < _e1002));
let _e1076 = global_2.member[bitcast<u32>(select(0i, _e1071, (_e1071 > 0i)))];
let _e1078 = local_3[0u];
let _e1081 = (_e1067 + ((bitcast<f32>(_e1076) - _e1067) * _e1078));
let _e1082 = (_e985 + _e983);
let _e1083 = local_2.member[1u];
let _e1084 = (_e1082 + _e1083);
let _e1086 = select(_e1002, _e1084, (_e1084 < _e1002));
let _e1091 = global_2.member[bitcast<u32>(select(0i, _e1086, (_e1086 > 0i)))];
let _e1092 = bitcast<f32>(_e1091);
let _e1093 = local_2.member[2u];
let _e1094 = (_e1082 + _e1093);
let _e1096 = select(_e1002, _e1094, (_e1094 < _e1002));
let _e1101 = global_2.member[bitcast<u32>(select(0i, _e1096, (_e1096 > 0i)))];
let _e1103 = local_3[0u];
let _e1107 = local_3[1u];
let _e1112 = local_3[2u];
let _e1120 = global_1.member.member_5.member_4.member;
let _e1126 = global_1.member.member_5.member_4.member_1;
let _e1127 = (((_e1056 + (((_e1081 + (((_e1092 + ((bitcast<f32>(_e1101) - _e1092) * _e1103)) - _e1081) * _e1107)) - _e1056) * _e1112)) * _e1120) + _e1126);
let _e1129 = select(0f, _e1127, (_e1127 > 0f));
phi_11176_ = type_20(select(1f, _e1129, (_e1129 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2542 = phi_11176_;
let _e2544 = select(-0.5f, _e403, (_e403 > -0.5f));
let _e2546 = select(_e468, _e2544, (_e2544 < _e468));
let _e2548 = select(-0.5f, _e421, (_e421 > -0.5f));
let _e2550 = select(_e478, _e2548, (_e2548 < _e478));
let _e2552 = select(-0.5f, _e439, (_e439 > -0.5f));
let _e2554 = select(_e488, _e2552, (_e2552 < _e488));
let _e2556 = select(-1f, _e2546, (_e2546 > -1f));
let _e2558 = select(_e467, _e2556, (_e2556 < _e467));
let _e2565 = select(0i, select(select(i32(_e2558), i32(-2147483648), (_e2558 < -2147483600f)), 2147483647i, (_e2558 > 2147483500f)), (_e2558 == _e2558));
let _e2569 = (_e2565 - select(0i, 1i, (_e2558 < f32(_e2565))));
let _e2571 = select(-1f, _e2550, (_e2550 > -1f));
let _e2573 = select(_e477, _e2571, (_e2571 < _e477));
let _e2580 = select(0i, select(select(i32(_e2573), i32(-2147483648), (_e2573 < -2147483600f)), 2147483647i, (_e2573 > 2147483500f)), (_e2573 == _e2573));
let _e2584 = (_e2580 - select(0i, 1i, (_e2573 < f32(_e2580))));
let _e2586 = select(-1f, _e2554, (_e2554 > -1f));
let _e2588 = select(_e487, _e2586, (_e2586 < _e487));
let _e2595 = select(0i, select(select(i32(_e2588), i32(-2147483648), (_e2588 < -2147483600f)), 2147483647i, (_e2588 > 2147483500f)), (_e2588 == _e2588));
let _e2599 = (_e2595 - select(0i, 1i, (_e2588 < f32(_e2595))));
let _e2604 = global_1.member.member_5.member_5[0u];
let _e2609 = global_1.member.member_5.member_5[1u];
let _e2617 = (select(0i, select(select(i32(_e477), i32(-2147483648), (_e477 < -2147483600f)), 2147483647i, (_e477 > 2147483500f)), (_e477 == _e477)) - 1i);
let _e2620 = (_e2584 + 1i);
let _e2630 = (select(0i, select(select(i32(_e487), i32(-2147483648), (_e487 < -2147483600f)), 2147483647i, (_e487 > 2147483500f)), (_e487 == _e487)) - 1i);
let _e2633 = (_e2599 + 1i);
let _e2643 = (select(0i, select(select(i32(_e467), i32(-2147483648), (_e467 < -2147483600f)), 2147483647i, (_e467 > 2147483500f)), (_e467 == _e467)) - 1i);
let _e2644 = (_e2569 - 1i);
let _e2649 = (_e2569 + 1i);
let _e2652 = (_e2569 + 2i);
let _e2655 = (select(0i, _e2584, (_e2584 > 0i)) * _e2604);
let _e2656 = (select(_e2617, _e2620, (_e2620 < _e2617)) * _e2604);
let _e2657 = (select(0i, _e2599, (_e2599 > 0i)) * _e2609);
let _e2658 = (select(_e2630, _e2633, (_e2633 < _e2630)) * _e2609);
local = type_18(array<i32, 4>(select(0i, _e2644, (_e2644 > 0i)), select(0i, _e2569, (_e2569 > 0i)), select(_e2643, _e2649, (_e2649 < _e2643)), select(_e2643, _e2652, (_e2652 < _e2643))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_1 = vec3<f32>((_e2546 - f32(_e2569)), (_e2550 - f32(_e2584)), (_e2554 - f32(_e2599)));
let _e2669 = (_e2657 + _e2655);
let _e2672 = local.member[1u];
let _e2673 = (_e2669 + _e2672);
let _e2675 = (bitcast<i32>(_e91) - 1i);
let _e2677 = select(_e2675, _e2673, (_e2673 < _e2675));
let _e2682 = global_2.member[bitcast<u32>(select(0i, _e2677, (_e2677 > 0i)))];
let _e2683 = bitcast<f32>(_e2682);
let _e2686 = local.member[2u];
let _e2687 = (_e2669 + _e2686);
let _e2689 = select(_e2675, _e2687, (_e2687 < _e2675));
let _e2694 = global_2.member[bitcast<u32>(select(0i, _e2689, (_e2689 > 0i)))];
let _e2696 = local_1[0u];
let _e2699 = (_e2683 + ((bitcast<f32>(_e2694) - _e2683) * _e2696));
let _e2700 = (_e2657 + _e2656);
let _e2701 = local.member[1u];
let _e2702 = (_e2700 + _e2701);
let _e2704 = select(_e2675, _e2702, (_e2702 < _e2675));
let _e2709 = global_2.member[bitcast<u32>(select(0i, _e2704, (_e2704 > 0i)))];
let _e2710 = bitcast<f32>(_e2709);
let _e2711 = local.member[2u];
let _e2712 = (_e2700 + _e2711);
let _e2714 = select(_e2675, _e2712, (_e2712 < _e2675));
let _e2719 = global_2.member[bitcast<u32>(select(0i, _e2714, (_e2714 > 0i)))];
let _e2721 = local_1[0u];
let _e2726 = local_1[1u];
let _e2729 = (_e2699 + (((_e2710 + ((bitcast<f32>(_e2719) - _e2710) * _e2721)) - _e2699) * _e2726));
let _e2730 = (_e2658 + _e2655);
let _e2731 = local.member[1u];
let _e2732 = (_e2730 + _e2731);
let _e2734 = select(_e2675, _e2732, (_e2732 < _e2675));
let _e2739 = global_2.member[bitcast<u32>(select(0i, _e2734, (_e2734 > 0i)))];
let _e2740 = bitcast<f32>(_e2739);
let _e2741 = local.member[2u];
let _e2742 = (_e2730 + _e2741);
let _e2744 = select(_e2675, _e2742, (_e2742 < _e2675));
let _e2749 = global_2.member[bitcast<u32>(select(0i, _e2744, (_e2744 > 0i)))];
let _e2751 = local_1[0u];
let _e2754 = (_e2740 + ((bitcast<f32>(_e2749) - _e2740) * _e2751));
let _e2755 = (_e2658 + _e2656);
let _e2756 = local.member[1u];
let _e2757 = (_e2755 + _e2756);
let _e2759 = select(_e2675, _e2757, (_e2757 < _e2675));
let _e2764 = global_2.member[bitcast<u32>(select(0i, _e2759, (_e2759 > 0i)))];
let _e2765 = bitcast<f32>(_e2764);
let _e2766 = local.member[2u];
let _e2767 = (_e2755 + _e2766);
let _e2769 = select(_e2675, _e2767, (_e2767 < _e2675));
let _e2774 = global_2.member[bitcast<u32>(select(0i, _e2769, (_e2769 > 0i)))];
let _e2776 = local_1[0u];
let _e2780 = local_1[1u];
let _e2785 = local_1[2u];
let _e2793 = global_1.member.member_5.member_4.member;
let _e2799 = global_1.member.member_5.member_4.member_1;
let _e2800 = (((_e2729 + (((_e2754 + (((_e2765 + ((bitcast<f32>(_e2774) - _e2765) * _e2776)) - _e2754) * _e2780)) - _e2729) * _e2785)) * _e2793) + _e2799);
let _e2802 = select(0f, _e2800, (_e2800 > 0f));
if ((_e861 & 16u) == 0u) {
phi_12697_ = type_21(1f, 1f, 1f);
} else {
let _e2809 = global_1.member.member_18;
let _e2813 = global_1.member.member_22.member;
let _e2823 = ((((_e2809.member * _e311) + (_e2809.member_1 * _e320)) + (_e2809.member_2 * _e293)) + _e2809.member_3);
let _e2829 = ((((_e2809.member * _e332) + (_e2809.member_1 * _e337)) + (_e2809.member_2 * _e326)) + _e2809.member_3);
let _e2831 = select(_e2829, _e2823, (_e2823 < _e2829));
let _e2833 = select(_e2829, _e2823, (_e2823 > _e2829));
let _e2835 = (_e2833 - _e2831);
let _e2838 = (-(_e2831) / select(1e-30f, _e2835, (_e2835 > 1e-30f)));
let _e2840 = select(0f, _e2838, (_e2838 > 0f));
let _e2846 = select(select(select(1f, _e2840, (_e2840 < 1f)), 1f, (_e2833 <= 0f)), 0f, (_e2831 > 0f));
let _e2848 = (_e2813 > 0.5f);
let _e2857 = global_1.member.member_19;
let _e2861 = global_1.member.member_22.member_1;
let _e2871 = ((((_e2857.member * _e311) + (_e2857.member_1 * _e320)) + (_e2857.member_2 * _e293)) + _e2857.member_3);
let _e2877 = ((((_e2857.member * _e332) + (_e2857.member_1 * _e337)) + (_e2857.member_2 * _e326)) + _e2857.member_3);
let _e2879 = select(_e2877, _e2871, (_e2871 < _e2877));
let _e2881 = select(_e2877, _e2871, (_e2871 > _e2877));
let _e2883 = (_e2881 - _e2879);
let _e2886 = (-(_e2879) / select(1e-30f, _e2883, (_e2883 > 1e-30f)));
let _e2888 = select(0f, _e2886, (_e2886 > 0f));
let _e2894 = select(select(select(1f, _e2888, (_e2888 < 1f)), 1f, (_e2881 <= 0f)), 0f, (_e2879 > 0f));
let _e2896 = (_e2861 > 0.5f);
let _e2905 = global_1.member.member_20;
let _e2909 = global_1.member.member_22.member_2;
let _e2919 = ((((_e2905.member * _e311) + (_e2905.member_1 * _e320)) + (_e2905.member_2 * _e293)) + _e2905.member_3);
let _e2925 = ((((_e2905.member * _e332) + (_e2905.member_1 * _e337)) + (_e2905.member_2 * _e326)) + _e2905.member_3);
let _e2927 = select(_e2925, _e2919, (_e2919 < _e2925));
let _e2929 = select(_e2925, _e2919, (_e2919 > _e2925));
let _e2931 = (_e2929 - _e2927);
let _e2934 = (-(_e2927) / select(1e-30f, _e2931, (_e2931 > 1e-30f)));
let _e2936 = select(0f, _e2934, (_e2934 > 0f));
let _e2942 = select(select(select(1f, _e2936, (_e2936 < 1f)), 1f, (_e2929 <= 0f)), 0f, (_e2927 > 0f));
let _e2944 = (_e2909 > 0.5f);
let _e2953 = global_1.member.member_21;
let _e2957 = global_1.member.member_22.member_3;
let _e2967 = ((((_e2953.member * _e311) + (_e2953.member_1 * _e320)) + (_e2953.member_2 * _e293)) + _e2953.member_3);
let _e2973 = ((((_e2953.member * _e332) + (_e2953.member_1 * _e337)) + (_e2953.member_2 * _e326)) + _e2953.member_3);
let _e2975 = select(_e2973, _e2967, (_e2967 < _e2973));
let _e2977 = select(_e2973, _e2967, (_e2967 > _e2973));
let _e2979 = (_e2977 - _e2975);
let _e2982 = (-(_e2975) / select(1e-30f, _e2979, (_e2979 > 1e-30f)));
let _e2984 = select(0f, _e2982, (_e2982 > 0f));
let _e2990 = select(select(select(1f, _e2984, (_e2984 < 1f)), 1f, (_e2977 <= 0f)), 0f, (_e2975 > 0f));
let _e2992 = (_e2957 > 0.5f);
phi_12697_ = type_21(((((1f * _e2846) * _e2894) * _e2942) * _e2990), ((((1f * select(1f, _e2846, _e2848)) * select(1f, _e2894, _e2896)) * select(1f, _e2942, _e2944)) * select(1f, _e2990, _e2992)), ((((1f * select(1f, 0f, (_e2848 && (_e2829 > 0f)))) * select(1f, 0f, (_e2896 && (_e2877 > 0f)))) * select(1f, 0f, (_e2944 && (_e2925 > 0f)))) * select(1f, 0f, (_e2992 && (_e2973 > 0f)))));
}
let _e3001 = phi_12697_;
let _e3002 = (_e332 - _e311);
let _e3003 = (_e337 - _e320);
let _e3004 = (_e326 - _e293);
let _e3009 = (((_e3002 * _e3002) + (_e3003 * _e3003)) + (_e3004 * _e3004));
let _e3013 = (_e498 < 1e-12f);
let _e3015 = (1f / select(_e493, 1f, _e3013));
let _e3017 = ((-0.5f - _e403) * _e3015);
let _e3019 = ((_e468 - _e403) * _e3015);
let _e3025 = select(_e3019, _e3017, (_e3017 < _e3019));
let _e3027 = select(0f, _e3025, (_e3025 > 0f));
let _e3030 = select(select(1f, _e3027, (_e3027 < 1f)), select(2f, 0f, ((_e403 >= -0.5f) && (_e403 <= _e468))), _e3013);
let _e3032 = select(_e3019, _e3017, (_e3017 > _e3019));
let _e3034 = select(0f, _e3032, (_e3032 > 0f));
let _e3037 = select(select(1f, _e3034, (_e3034 < 1f)), 1f, _e3013);
let _e3038 = (_e501 < 1e-12f);
let _e3040 = (1f / select(_e494, 1f, _e3038));
let _e3042 = ((-0.5f - _e421) * _e3040);
let _e3044 = ((_e478 - _e421) * _e3040);
let _e3050 = select(_e3044, _e3042, (_e3042 < _e3044));
let _e3052 = select(0f, _e3050, (_e3050 > 0f));
let _e3055 = select(select(1f, _e3052, (_e3052 < 1f)), select(2f, 0f, ((_e421 >= -0.5f) && (_e421 <= _e478))), _e3038);
let _e3057 = select(_e3044, _e3042, (_e3042 > _e3044));
let _e3059 = select(0f, _e3057, (_e3057 > 0f));
let _e3062 = select(select(1f, _e3059, (_e3059 < 1f)), 1f, _e3038);
let _e3063 = (_e506 < 1e-12f);
let _e3065 = (1f / select(_e495, 1f, _e3063));
let _e3067 = ((-0.5f - _e439) * _e3065);
let _e3069 = ((_e488 - _e439) * _e3065);
let _e3075 = select(_e3069, _e3067, (_e3067 < _e3069));
let _e3077 = select(0f, _e3075, (_e3075 > 0f));
let _e3080 = select(select(1f, _e3077, (_e3077 < 1f)), select(2f, 0f, ((_e439 >= -0.5f) && (_e439 <= _e488))), _e3063);
let _e3082 = select(_e3069, _e3067, (_e3067 > _e3069));
let _e3084 = select(0f, _e3082, (_e3082 > 0f));
let _e3087 = select(select(1f, _e3084, (_e3084 < 1f)), 1f, _e3063);
let _e3089 = select(_e3062, _e3037, (_e3037 < _e3062));
let _e3093 = select(_e3055, _e3030, (_e3030 > _e3055));
let _e3096 = (select(_e3087, _e3089, (_e3089 < _e3087)) - select(_e3080, _e3093, (_e3093 > _e3080)));
let _e3103 = global_1.member.member_4.member_3;
let _e3104 = ((sqrt(select(0f, _e3009, (_e3009 > 0f))) * select(0f, _e3096, (_e3096 > 0f))) * _e3103);
let _e3106 = (select(1f, _e2802, (_e2802 < 1f)) * 255f);
let _e3107 = (_e2542.member * 255f);
let _e3108 = (255f - 1f);
let _e3110 = select(0f, _e3106, (_e3106 > 0f));
let _e3112 = select(_e3108, _e3110, (_e3110 < _e3108));
let _e3119 = select(0i, select(select(i32(_e3112), i32(-2147483648), (_e3112 < -2147483600f)), 2147483647i, (_e3112 > 2147483500f)), (_e3112 == _e3112));
let _e3123 = (_e3119 - select(0i, 1i, (_e3112 < f32(_e3119))));
let _e3125 = select(0f, _e3107, (_e3107 > 0f));
let _e3127 = select(_e3108, _e3125, (_e3125 < _e3108));
let _e3134 = select(0i, select(select(i32(_e3127), i32(-2147483648), (_e3127 < -2147483600f)), 2147483647i, (_e3127 > 2147483500f)), (_e3127 == _e3127));
let _e3138 = (_e3134 - select(0i, 1i, (_e3127 < f32(_e3134))));
let _e3141 = (((_e3123 * 256i) + _e3138) * 4i);
let _e3143 = (_e3106 - f32(_e3123));
let _e3145 = (_e3107 - f32(_e3138));
let _e3147 = (bitcast<i32>(_e98) - 1i);
let _e3149 = select(_e3147, _e3141, (_e3141 < _e3147));
let _e3155 = global_4.member[bitcast<u32>(select(0i, _e3149, (_e3149 > 0i)))];
let _e3156 = (_e3141 + 4i);
let _e3158 = select(_e3147, _e3156, (_e3156 < _e3147));
let _e3164 = global_4.member[bitcast<u32>(select(0i, _e3158, (_e3158 > 0i)))];
let _e3165 = (_e3141 + 1024i);
let _e3167 = select(_e3147, _e3165, (_e3165 < _e3147));
let _e3173 = global_4.member[bitcast<u32>(select(0i, _e3167, (_e3167 > 0i)))];
let _e3174 = (_e3141 + 1028i);
let _e3176 = select(_e3147, _e3174, (_e3174 < _e3147));
let _e3182 = global_4.member[bitcast<u32>(select(0i, _e3176, (_e3176 > 0i)))];
let _e3187 = (bitcast<f32>(((_e3155 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3195 = (_e3187 + (((bitcast<f32>(((_e3164 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3187) * _e3145));
let _e3200 = (bitcast<f32>(((_e3173 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3224 = (bitcast<f32>((((_e3155 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3232 = (_e3224 + (((bitcast<f32>((((_e3164 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3224) * _e3145));
let _e3237 = (bitcast<f32>((((_e3173 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3249 = (_e3141 + 1i);
let _e3251 = select(_e3147, _e3249, (_e3249 < _e3147));
let _e3257 = global_4.member[bitcast<u32>(select(0i, _e3251, (_e3251 > 0i)))];
let _e3258 = (_e3141 + 5i);
let _e3260 = select(_e3147, _e3258, (_e3258 < _e3147));
let _e3266 = global_4.member[bitcast<u32>(select(0i, _e3260, (_e3260 > 0i)))];
let _e3267 = (_e3141 + 1025i);
let _e3269 = select(_e3147, _e3267, (_e3267 < _e3147));
let _e3275 = global_4.member[bitcast<u32>(select(0i, _e3269, (_e3269 > 0i)))];
let _e3276 = (_e3141 + 1029i);
let _e3278 = select(_e3147, _e3276, (_e3276 < _e3147));
let _e3284 = global_4.member[bitcast<u32>(select(0i, _e3278, (_e3278 > 0i)))];
let _e3289 = (bitcast<f32>(((_e3257 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3297 = (_e3289 + (((bitcast<f32>(((_e3266 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3289) * _e3145));
let _e3302 = (bitcast<f32>(((_e3275 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3326 = (bitcast<f32>((((_e3257 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3334 = (_e3326 + (((bitcast<f32>((((_e3266 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3326) * _e3145));
let _e3339 = (bitcast<f32>((((_e3275 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3354 = (_e3104 * _e3001.member_1);
let _e3356 = -(((_e3232 + (((_e3237 + (((bitcast<f32>((((_e3182 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3237) * _e3145)) - _e3232) * _e3143)) * _e3354));
let _e3358 = select(-87f, _e3356, (_e3356 > -87f));
let _e3360 = select(88f, _e3358, (_e3358 < 88f));
let _e3362 = ((_e3360 * 1.442695f) + 0.5f);
let _e3364 = select(-127f, _e3362, (_e3362 > -127f));
let _e3366 = select(128f, _e3364, (_e3364 < 128f));
let _e3373 = select(0i, select(select(i32(_e3366), i32(-2147483648), (_e3366 < -2147483600f)), 2147483647i, (_e3366 > 2147483500f)), (_e3366 == _e3366));
let _e3377 = (_e3373 - select(0i, 1i, (_e3366 < f32(_e3373))));
let _e3378 = f32(_e3377);
let _e3382 = ((_e3360 - (_e3378 * 0.6933594f)) - (_e3378 * -2.1219444e-4f));
let _e3404 = -(((_e3297 + (((_e3302 + (((bitcast<f32>(((_e3284 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3302) * _e3145)) - _e3297) * _e3143)) * _e3354));
let _e3406 = select(-87f, _e3404, (_e3404 > -87f));
let _e3408 = select(88f, _e3406, (_e3406 < 88f));
let _e3410 = ((_e3408 * 1.442695f) + 0.5f);
let _e3412 = select(-127f, _e3410, (_e3410 > -127f));
let _e3414 = select(128f, _e3412, (_e3412 < 128f));
let _e3421 = select(0i, select(select(i32(_e3414), i32(-2147483648), (_e3414 < -2147483600f)), 2147483647i, (_e3414 > 2147483500f)), (_e3414 == _e3414));
let _e3425 = (_e3421 - select(0i, 1i, (_e3414 < f32(_e3421))));
let _e3426 = f32(_e3425);
let _e3430 = ((_e3408 - (_e3426 * 0.6933594f)) - (_e3426 * -2.1219444e-4f));
let _e3452 = -(((_e3334 + (((_e3339 + (((bitcast<f32>((((_e3284 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3339) * _e3145)) - _e3334) * _e3143)) * _e3354));
let _e3454 = select(-87f, _e3452, (_e3452 > -87f));
let _e3456 = select(88f, _e3454, (_e3454 < 88f));
let _e3458 = ((_e3456 * 1.442695f) + 0.5f);
let _e3460 = select(-127f, _e3458, (_e3458 > -127f));
let _e3462 = select(128f, _e3460, (_e3460 < 128f));
let _e3469 = select(0i, select(select(i32(_e3462), i32(-2147483648), (_e3462 < -2147483600f)), 2147483647i, (_e3462 > 2147483500f)), (_e3462 == _e3462));
let _e3473 = (_e3469 - select(0i, 1i, (_e3462 < f32(_e3469))));
let _e3474 = f32(_e3473);
let _e3478 = ((_e3456 - (_e3474 * 0.6933594f)) - (_e3474 * -2.1219444e-4f));
let _e3500 = -(((_e3195 + (((_e3200 + (((bitcast<f32>(((_e3182 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3200) * _e3145)) - _e3195) * _e3143)) * (_e3104 * _e3001.member)));
let _e3502 = select(-87f, _e3500, (_e3500 > -87f));
let _e3504 = select(88f, _e3502, (_e3502 < 88f));
let _e3506 = ((_e3504 * 1.442695f) + 0.5f);
let _e3508 = select(-127f, _e3506, (_e3506 > -127f));
let _e3510 = select(128f, _e3508, (_e3508 < 128f));
let _e3517 = select(0i, select(select(i32(_e3510), i32(-2147483648), (_e3510 < -2147483600f)), 2147483647i, (_e3510 > 2147483500f)), (_e3510 == _e3510));
let _e3521 = (_e3517 - select(0i, 1i, (_e3510 < f32(_e3517))));
let _e3522 = f32(_e3521);
let _e3526 = ((_e3504 - (_e3522 * 0.6933594f)) - (_e3522 * -2.1219444e-4f));
let _e3546 = ((1f + (_e3526 * (1f + (_e3526 * (0.5f + (_e3526 * (0.16666667f + (_e3526 * (0.041666668f + (_e3526 * (0.008333334f + (_e3526 * (0.001388889f + (_e3526 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3521 + 127i)) << bitcast<u32>(23i))));
if _e881 {
let _e3561 = global_1.member.member_24.member_2;
let _e3564 = (_e2542.member_3.x * _e3001.member_2);
let _e3566 = (_e2542.member_3.y * _e3001.member_2);
let _e3568 = (_e2542.member_3.z * _e3001.member_2);
let _e3569 = (0.5f * (_e250 / _e202));
let _e3573 = (_e180 + (_e3564 * _e3569));
let _e3574 = (_e191 + (_e3566 * _e3569));
let _e3575 = (_e202 + (_e3568 * _e3569));
let _e3577 = (2f * _e250);
let _e3579 = ((_e3575 * _e3575) + (_e3577 * _e3568));
let _e3583 = (_e3575 + sqrt(select(0f, _e3579, (_e3579 > 0f))));
let _e3587 = (0.5f * (_e3577 / select(1e-6f, _e3583, (_e3583 > 1e-6f))));
let _e3591 = (_e3573 + (_e3564 * _e3587));
let _e3592 = (_e3574 + (_e3566 * _e3587));
let _e3593 = (_e3575 + (_e3568 * _e3587));
let _e3597 = (_e3561 * _e3561);
let _e3599 = (_e3593 * _e3593);
let _e3607 = (((_e3575 <= 0f) || (_e3579 <= 0f)) || ((_e3593 <= 0f) || (_e3599 <= (_e3597 * (((_e3591 * _e3591) + (_e3592 * _e3592)) + _e3599)))));
let _e3621 = (_e180 + ((_e2542.member_4.x * _e3001.member_2) * _e250));
let _e3622 = (_e191 + ((_e2542.member_4.y * _e3001.member_2) * _e250));
let _e3623 = (_e202 + ((_e2542.member_4.z * _e3001.member_2) * _e250));
let _e3625 = (_e3623 * _e3623);
let _e3634 = ((_e861 & 1u) != 0u);
phi_13721_ = select(select(select(_e3593, _e3575, _e3607), _e3623, _e3634), _e202, _e868);
phi_13722_ = select(select(select(_e3592, _e3574, _e3607), _e3622, _e3634), _e191, _e868);
phi_13723_ = select(select(select(_e3591, _e3573, _e3607), _e3621, _e3634), _e180, _e868);
phi_13724_ = (select(_e3607, ((_e3623 <= 0f) || (_e3625 <= (_e3597 * (((_e3621 * _e3621) + (_e3622 * _e3622)) + _e3625)))), _e3634) && !(_e868));
} else {
phi_13721_ = _e202;
phi_13722_ = _e191;
phi_13723_ = _e180;
phi_13724_ = false;
}
let _e3645 = phi_13721_;
let _e3647 = phi_13722_;
let _e3649 = phi_13723_;
let _e3651 = phi_13724_;
global_6.member[_e126] = (_e137 + _e265);
global_6.member[_e138] = (_e147 + _e272);
global_6.member[_e149] = (_e158 + _e374);
global_6.member[_e160] = (_e169 + _e377);
global_6.member[_e171] = _e3649;
global_6.member[_e182] = _e3647;
global_6.member[_e193] = _e3645;
global_6.member[_e204] = select((_e213 * (((1f + (_e3382 * (1f + (_e3382 * (0.5f + (_e3382 * (0.16666667f + (_e3382 * (0.041666668f + (_e3382 * (0.008333334f + (_e3382 * (0.001388889f + (_e3382 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3377 + 127i)) << bitcast<u32>(23i)))) * _e3546)), _e213, _e868);
global_6.member[_e215] = select((_e224 * (((1f + (_e3430 * (1f + (_e3430 * (0.5f + (_e3430 * (0.16666667f + (_e3430 * (0.041666668f + (_e3430 * (0.008333334f + (_e3430 * (0.001388889f + (_e3430 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3425 + 127i)) << bitcast<u32>(23i)))) * _e3546)), _e224, _e868);
global_6.member[_e226] = select((_e235 * (((1f + (_e3478 * (1f + (_e3478 * (0.5f + (_e3478 * (0.16666667f + (_e3478 * (0.041666668f + (_e3478 * (0.008333334f + (_e3478 * (0.001388889f + (_e3478 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3473 + 127i)) << bitcast<u32>(23i)))) * _e3546)), _e235, _e868);
global_6.member[_e237] = select(_e246, 1f, _e3651);
}
}
}
break;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}

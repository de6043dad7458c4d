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
fn function_() {
var local: type_18;
var local_1: vec3<f32>;
var local_2: type_18;
var local_3: vec3<f32>;
var local_4: type_18;
var local_5: vec3<f32>;
var phi_5835_: type_19;
var phi_7155_: type_20;
var phi_8676_: type_21;
var phi_9700_: f32;
var phi_9701_: f32;
var phi_9702_: f32;
var phi_9703_: bool;
switch bitcast<i32>(0u) {
default: {
let _e86 = global;
let _e89 = arrayLength((&global_2.member));
let _e93 = arrayLength((&global_4.member));
let _e100 = global_1.member.member_1;
let _e103 = (_e86.x + _e100.x);
let _e106 = (_e86.y + _e100.y);
if (_e103 < _e100.z) {
if (_e106 < _e100.w) {
let _e114 = global_1.member.member[0u];
let _e118 = global_1.member.member[1u];
let _e119 = (_e114 * _e118);
let _e121 = ((_e106 * _e114) + _e103);
let _e122 = bitcast<i32>(_e121);
let _e124 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e126 = select(_e124, _e122, (_e122 < _e124));
let _e132 = global_6.member[bitcast<u32>(select(0i, _e126, (_e126 > 0i)))];
let _e133 = (_e119 + _e121);
let _e134 = bitcast<i32>(_e133);
let _e136 = select(_e124, _e134, (_e134 < _e124));
let _e142 = global_6.member[bitcast<u32>(select(0i, _e136, (_e136 > 0i)))];
let _e144 = ((2u * _e119) + _e121);
let _e145 = bitcast<i32>(_e144);
let _e147 = select(_e124, _e145, (_e145 < _e124));
let _e153 = global_6.member[bitcast<u32>(select(0i, _e147, (_e147 > 0i)))];
let _e155 = ((3u * _e119) + _e121);
let _e156 = bitcast<i32>(_e155);
let _e158 = select(_e124, _e156, (_e156 < _e124));
let _e164 = global_6.member[bitcast<u32>(select(0i, _e158, (_e158 > 0i)))];
let _e166 = ((4u * _e119) + _e121);
let _e167 = bitcast<i32>(_e166);
let _e169 = select(_e124, _e167, (_e167 < _e124));
let _e175 = global_6.member[bitcast<u32>(select(0i, _e169, (_e169 > 0i)))];
let _e177 = ((5u * _e119) + _e121);
let _e178 = bitcast<i32>(_e177);
let _e180 = select(_e124, _e178, (_e178 < _e124));
let _e186 = global_6.member[bitcast<u32>(select(0i, _e180, (_e180 > 0i)))];
let _e188 = ((6u * _e119) + _e121);
let _e189 = bitcast<i32>(_e188);
let _e191 = select(_e124, _e189, (_e189 < _e124));
let _e197 = global_6.member[bitcast<u32>(select(0i, _e191, (_e191 > 0i)))];
let _e199 = ((7u * _e119) + _e121);
let _e200 = bitcast<i32>(_e199);
let _e202 = select(_e124, _e200, (_e200 < _e124));
let _e208 = global_6.member[bitcast<u32>(select(0i, _e202, (_e202 > 0i)))];
let _e210 = ((8u * _e119) + _e121);
let _e211 = bitcast<i32>(_e210);
let _e213 = select(_e124, _e211, (_e211 < _e124));
let _e219 = global_6.member[bitcast<u32>(select(0i, _e213, (_e213 > 0i)))];
let _e221 = ((9u * _e119) + _e121);
let _e222 = bitcast<i32>(_e221);
let _e224 = select(_e124, _e222, (_e222 < _e124));
let _e230 = global_6.member[bitcast<u32>(select(0i, _e224, (_e224 > 0i)))];
let _e232 = ((10u * _e119) + _e121);
let _e233 = bitcast<i32>(_e232);
let _e235 = select(_e124, _e233, (_e233 < _e124));
let _e241 = global_6.member[bitcast<u32>(select(0i, _e235, (_e235 > 0i)))];
let _e245 = global_1.member.member_4.member_2;
let _e248 = (1f / select(1e-6f, _e197, (_e197 > 1e-6f)));
let _e252 = global_1.member.member_7.member_3;
let _e253 = (_e245 * _e252);
let _e258 = global_1.member.member_8.member;
let _e260 = (((_e175 * _e248) - _e258) * _e253);
let _e265 = global_1.member.member_8.member_1;
let _e267 = (((_e186 * _e248) - _e265) * _e253);
let _e271 = ((f32(bitcast<i32>(_e103)) - 0.5f) + _e132);
let _e275 = global_1.member.member_2[3u];
let _e276 = (_e275 + 1u);
let _e278 = select(1u, _e276, (_e276 > 0u));
let _e279 = (_e278 == 0u);
if _e279 {
break;
}
let _e284 = ((f32(bitcast<i32>((_e106 % _e278))) - 0.5f) + _e142);
let _e288 = global_1.member.member_4.member;
let _e292 = global_1.member.member_8.member_2;
let _e293 = (_e288 - _e292);
let _e297 = global_1.member.member_7.member;
let _e304 = global_1.member.member_7.member_2;
let _e306 = ((_e297 + (_e258 * _e293)) + ((_e271 + 0.5f) * _e304));
let _e310 = global_1.member.member_7.member_1;
let _e315 = ((_e310 + (_e265 * _e293)) + ((_e284 + 0.5f) * _e304));
let _e321 = global_1.member.member_4.member_1;
let _e322 = (_e321 - _e292);
let _e327 = ((_e297 + (_e258 * _e322)) + (((_e271 + _e260) + 0.5f) * _e304));
let _e332 = ((_e310 + (_e265 * _e322)) + (((_e284 + _e267) + 0.5f) * _e304));
if _e279 {
break;
}
let _e335 = bitcast<i32>(((_e106 / _e278) * 3u));
let _e337 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e339 = select(_e337, _e335, (_e335 < _e337));
let _e345 = global_5.member[bitcast<u32>(select(0i, _e339, (_e339 > 0i)))];
let _e346 = (_e335 + 1i);
let _e348 = select(_e337, _e346, (_e346 < _e337));
let _e354 = global_5.member[bitcast<u32>(select(0i, _e348, (_e348 > 0i)))];
let _e355 = (_e335 + 2i);
let _e357 = select(_e337, _e355, (_e355 < _e337));
let _e363 = global_5.member[bitcast<u32>(select(0i, _e357, (_e357 > 0i)))];
let _e366 = (1f / select(1e-6f, _e363, (_e363 > 1e-6f)));
let _e369 = (((_e345 * _e366) - _e258) * _e253);
let _e372 = (((_e354 * _e366) - _e265) * _e253);
let _e384 = global_1.member.member_5.member;
let _e397 = global_1.member.member_5.member.member_3;
let _e398 = ((((_e384.member * _e306) + (_e384.member_1 * _e315)) + (_e384.member_2 * _e288)) + _e397);
let _e402 = global_1.member.member_5.member_1;
let _e415 = global_1.member.member_5.member_1.member_3;
let _e416 = ((((_e402.member * _e306) + (_e402.member_1 * _e315)) + (_e402.member_2 * _e288)) + _e415);
let _e420 = global_1.member.member_5.member_2;
let _e433 = global_1.member.member_5.member_2.member_3;
let _e434 = ((((_e420.member * _e306) + (_e420.member_1 * _e315)) + (_e420.member_2 * _e288)) + _e433);
let _e440 = ((((_e384.member * _e327) + (_e384.member_1 * _e332)) + (_e384.member_2 * _e321)) + _e397);
let _e446 = ((((_e402.member * _e327) + (_e402.member_1 * _e332)) + (_e402.member_2 * _e321)) + _e415);
let _e452 = ((((_e420.member * _e327) + (_e420.member_1 * _e332)) + (_e420.member_2 * _e321)) + _e433);
let _e457 = global_1.member.member_5.member_3.member_3;
let _e462 = global_1.member.member_5.member_3.member;
let _e463 = (_e462 - 0.5f);
let _e465 = select(-0.5f, _e440, (_e440 > -0.5f));
let _e467 = select(_e463, _e465, (_e465 < _e463));
let _e472 = global_1.member.member_5.member_3.member_1;
let _e473 = (_e472 - 0.5f);
let _e475 = select(-0.5f, _e446, (_e446 > -0.5f));
let _e477 = select(_e473, _e475, (_e475 < _e473));
let _e482 = global_1.member.member_5.member_3.member_2;
let _e483 = (_e482 - 0.5f);
let _e485 = select(-0.5f, _e452, (_e452 > -0.5f));
let _e487 = select(_e483, _e485, (_e485 < _e483));
let _e488 = (_e440 - _e398);
let _e489 = (_e446 - _e416);
let _e490 = (_e452 - _e434);
let _e493 = bitcast<f32>((bitcast<u32>(_e488) & 2147483647u));
let _e496 = bitcast<f32>((bitcast<u32>(_e489) & 2147483647u));
let _e498 = select(_e496, _e493, (_e493 > _e496));
let _e501 = bitcast<f32>((bitcast<u32>(_e490) & 2147483647u));
let _e510 = bitcast<f32>((bitcast<u32>((_e440 - _e467)) & 2147483647u));
let _e513 = bitcast<f32>((bitcast<u32>((_e446 - _e477)) & 2147483647u));
let _e515 = select(_e513, _e510, (_e510 > _e513));
let _e518 = bitcast<f32>((bitcast<u32>((_e452 - _e487)) & 2147483647u));
let _e522 = (_e467 + 0.5f);
let _e523 = (_e462 - 1f);
let _e525 = select(0f, _e522, (_e522 > 0f));
let _e527 = select(_e523, _e525, (_e525 < _e523));
let _e534 = select(0i, select(select(i32(_e527), i32(-2147483648), (_e527 < -2147483600f)), 2147483647i, (_e527 > 2147483500f)), (_e527 == _e527));
let _e543 = global_1.member.member_5.member_7[3u];
let _e544 = (_e543 & 31i);
let _e547 = (_e477 + 0.5f);
let _e548 = (_e472 - 1f);
let _e550 = select(0f, _e547, (_e547 > 0f));
let _e552 = select(_e548, _e550, (_e550 < _e548));
let _e559 = select(0i, select(select(i32(_e552), i32(-2147483648), (_e552 < -2147483600f)), 2147483647i, (_e552 > 2147483500f)), (_e552 == _e552));
let _e566 = (_e487 + 0.5f);
let _e567 = (_e482 - 1f);
let _e569 = select(0f, _e566, (_e566 > 0f));
let _e571 = select(_e567, _e569, (_e569 < _e567));
let _e578 = select(0i, select(select(i32(_e571), i32(-2147483648), (_e571 < -2147483600f)), 2147483647i, (_e571 > 2147483500f)), (_e571 == _e571));
let _e589 = global_1.member.member_5.member_6[3u];
let _e595 = global_1.member.member_5.member_6[0u];
let _e600 = global_1.member.member_5.member_6[1u];
let _e604 = ((_e589 + ((_e534 - select(0i, 1i, (_e527 < f32(_e534)))) >> bitcast<u32>(_e544))) + (_e595 * (((_e559 - select(0i, 1i, (_e552 < f32(_e559)))) >> bitcast<u32>(_e544)) + (_e600 * ((_e578 - select(0i, 1i, (_e571 < f32(_e578)))) >> bitcast<u32>(_e544))))));
let _e606 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e608 = select(_e606, _e604, (_e604 < _e606));
let _e614 = global_3.member[bitcast<u32>(select(0i, _e608, (_e608 > 0i)))];
let _e621 = global_1.member.member[3u];
let _e628 = (((_e621 & 64u) != 0u) || ((((select(_e501, _e498, (_e498 > _e501)) <= _e457) && ((select(_e518, _e515, (_e515 > _e518)) > _e457) || (_e614 != 0u))) && true) && ((_e621 & 32u) != 0u)));
if (select(0u, select(7u, select(3u, 1u, ((((_e260 == 0f) && (_e267 == 0f)) && (_e369 == 0f)) && (_e372 == 0f))), _e628), (_e241 == 0f)) > 1u) {
let _e636 = global_1.member.member[2u];
if _e279 {
break;
}
if _e279 {
break;
}
let _e638 = (_e636 == 2u);
let _e641 = (((_e636 == 1u) || _e638) || (_e636 == 5u));
if _e641 {
let _e894 = select(-1f, _e467, (_e467 > -1f));
let _e896 = select(_e462, _e894, (_e894 < _e462));
let _e903 = select(0i, select(select(i32(_e896), i32(-2147483648), (_e896 < -2147483600f)), 2147483647i, (_e896 > 2147483500f)), (_e896 == _e896));
let _e907 = (_e903 - select(0i, 1i, (_e896 < f32(_e903))));
let _e909 = select(-1f, _e477, (_e477 > -1f));
let _e911 = select(_e472, _e909, (_e909 < _e472));
let _e918 = select(0i, select(select(i32(_e911), i32(-2147483648), (_e911 < -2147483600f)), 2147483647i, (_e911 > 2147483500f)), (_e911 == _e911));
let _e922 = (_e918 - select(0i, 1i, (_e911 < f32(_e918))));
let _e924 = select(-1f, _e487, (_e487 > -1f));
let _e926 = select(_e482, _e924, (_e924 < _e482));
let _e933 = select(0i, select(select(i32(_e926), i32(-2147483648), (_e926 < -2147483600f)), 2147483647i, (_e926 > 2147483500f)), (_e926 == _e926));
let _e937 = (_e933 - select(0i, 1i, (_e926 < f32(_e933))));
let _e942 = global_1.member.member_5.member_5[0u];
let _e947 = global_1.member.member_5.member_5[1u];
let _e955 = (select(0i, select(select(i32(_e472), i32(-2147483648), (_e472 < -2147483600f)), 2147483647i, (_e472 > 2147483500f)), (_e472 == _e472)) - 1i);
let _e956 = (_e922 - 1i);
let _e961 = (_e922 + 1i);
let _e964 = (_e922 + 2i);
let _e974 = (select(0i, select(select(i32(_e482), i32(-2147483648), (_e482 < -2147483600f)), 2147483647i, (_e482 > 2147483500f)), (_e482 == _e482)) - 1i);
let _e975 = (_e937 - 1i);
let _e980 = (_e937 + 1i);
let _e983 = (_e937 + 2i);
let _e993 = (select(0i, select(select(i32(_e462), i32(-2147483648), (_e462 < -2147483600f)), 2147483647i, (_e462 > 2147483500f)), (_e462 == _e462)) - 1i);
let _e994 = (_e907 - 1i);
let _e999 = (_e907 + 1i);
let _e1002 = (_e907 + 2i);
let _e1005 = (select(0i, _e956, (_e956 > 0i)) * _e942);
let _e1006 = (select(0i, _e922, (_e922 > 0i)) * _e942);
let _e1007 = (select(_e955, _e961, (_e961 < _e955)) * _e942);
let _e1008 = (select(_e955, _e964, (_e964 < _e955)) * _e942);
let _e1009 = (select(0i, _e975, (_e975 > 0i)) * _e947);
let _e1010 = (select(0i, _e937, (_e937 > 0i)) * _e947);
let _e1011 = (select(_e974, _e980, (_e980 < _e974)) * _e947);
let _e1012 = (select(_e974, _e983, (_e983 < _e974)) * _e947);
local_4 = type_18(array<i32, 4>(select(0i, _e994, (_e994 > 0i)), select(0i, _e907, (_e907 > 0i)), select(_e993, _e999, (_e999 < _e993)), select(_e993, _e1002, (_e1002 < _e993))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_5 = vec3<f32>((_e467 - f32(_e907)), (_e477 - f32(_e922)), (_e487 - f32(_e937)));
let _e1023 = (_e1010 + _e1006);
let _e1026 = local_4.member[0u];
let _e1027 = (_e1023 + _e1026);
let _e1029 = (bitcast<i32>(_e89) - 1i);
let _e1031 = select(_e1029, _e1027, (_e1027 < _e1029));
let _e1036 = global_2.member[bitcast<u32>(select(0i, _e1031, (_e1031 > 0i)))];
let _e1037 = bitcast<f32>(_e1036);
let _e1040 = local_4.member[1u];
let _e1041 = (_e1023 + _e1040);
let _e1043 = select(_e1029, _e1041, (_e1041 < _e1029));
let _e1048 = global_2.member[bitcast<u32>(select(0i, _e1043, (_e1043 > 0i)))];
let _e1049 = bitcast<f32>(_e1048);
let _e1052 = local_4.member[2u];
let _e1053 = (_e1023 + _e1052);
let _e1055 = select(_e1029, _e1053, (_e1053 < _e1029));
let _e1060 = global_2.member[bitcast<u32>(select(0i, _e1055, (_e1055 > 0i)))];
let _e1061 = bitcast<f32>(_e1060);
let _e1064 = local_4.member[3u];
let _e1065 = (_e1023 + _e1064);
let _e1067 = select(_e1029, _e1065, (_e1065 < _e1029));
let _e1072 = global_2.member[bitcast<u32>(select(0i, _e1067, (_e1067 > 0i)))];
let _e1074 = local_5[0u];
let _e1077 = (_e1037 + ((_e1049 - _e1037) * _e1074));
let _e1078 = local_5[0u];
let _e1081 = (_e1049 + ((_e1061 - _e1049) * _e1078));
let _e1082 = local_5[0u];
let _e1085 = (_e1061 + ((bitcast<f32>(_e1072) - _e1061) * _e1082));
let _e1086 = (_e1010 + _e1007);
let _e1087 = local_4.member[0u];
let _e1088 = (_e1086 + _e1087);
let _e1090 = select(_e1029, _e1088, (_e1088 < _e1029));
let _e1095 = global_2.member[bitcast<u32>(select(0i, _e1090, (_e1090 > 0i)))];
let _e1096 = bitcast<f32>(_e1095);
let _e1097 = local_4.member[1u];
let _e1098 = (_e1086 + _e1097);
let _e1100 = select(_e1029, _e1098, (_e1098 < _e1029));
let _e1105 = global_2.member[bitcast<u32>(select(0i, _e1100, (_e1100 > 0i)))];
let _e1106 = bitcast<f32>(_e1105);
let _e1107 = local_4.member[2u];
let _e1108 = (_e1086 + _e1107);
let _e1110 = select(_e1029, _e1108, (_e1108 < _e1029));
let _e1115 = global_2.member[bitcast<u32>(select(0i, _e1110, (_e1110 > 0i)))];
let _e1116 = bitcast<f32>(_e1115);
let _e1117 = local_4.member[3u];
let _e1118 = (_e1086 + _e1117);
let _e1120 = select(_e1029, _e1118, (_e1118 < _e1029));
let _e1125 = global_2.member[bitcast<u32>(select(0i, _e1120, (_e1120 > 0i)))];
let _e1127 = local_5[0u];
let _e1131 = local_5[0u];
let _e1134 = (_e1106 + ((_e1116 - _e1106) * _e1131));
let _e1135 = local_5[0u];
let _e1139 = (_e1011 + _e1006);
let _e1140 = local_4.member[0u];
let _e1141 = (_e1139 + _e1140);
let _e1143 = select(_e1029, _e1141, (_e1141 < _e1029));
let _e1148 = global_2.member[bitcast<u32>(select(0i, _e1143, (_e1143 > 0i)))];
let _e1149 = bitcast<f32>(_e1148);
let _e1150 = local_4.member[1u];
let _e1151 = (_e1139 + _e1150);
let _e1153 = select(_e1029, _e1151, (_e1151 < _e1029));
let _e1158 = global_2.member[bitcast<u32>(select(0i, _e1153, (_e1153 > 0i)))];
let _e1159 = bitcast<f32>(_e1158);
let _e1160 = local_4.member[2u];
let _e1161 = (_e1139 + _e1160);
let _e1163 = select(_e1029, _e1161, (_e1161 < _e1029));
let _e1168 = global_2.member[bitcast<u32>(select(0i, _e1163, (_e1163 > 0i)))];
let _e1169 = bitcast<f32>(_e1168);
let _e1170 = local_4.member[3u];
let _e1171 = (_e1139 + _e1170);
let _e1173 = select(_e1029, _e1171, (_e1171 < _e1029));
let _e1178 = global_2.member[bitcast<u32>(select(0i, _e1173, (_e1173 > 0i)))];
let _e1180 = local_5[0u];
let _e1183 = (_e1149 + ((_e1159 - _e1149) * _e1180));
let _e1184 = local_5[0u];
let _e1187 = (_e1159 + ((_e1169 - _e1159) * _e1184));
let _e1188 = local_5[0u];
let _e1191 = (_e1169 + ((bitcast<f32>(_e1178) - _e1169) * _e1188));
let _e1192 = (_e1011 + _e1007);
let _e1193 = local_4.member[0u];
let _e1194 = (_e1192 + _e1193);
let _e1196 = select(_e1029, _e1194, (_e1194 < _e1029));
let _e1201 = global_2.member[bitcast<u32>(select(0i, _e1196, (_e1196 > 0i)))];
let _e1202 = bitcast<f32>(_e1201);
let _e1203 = local_4.member[1u];
let _e1204 = (_e1192 + _e1203);
let _e1206 = select(_e1029, _e1204, (_e1204 < _e1029));
let _e1211 = global_2.member[bitcast<u32>(select(0i, _e1206, (_e1206 > 0i)))];
let _e1212 = bitcast<f32>(_e1211);
let _e1213 = local_4.member[2u];
let _e1214 = (_e1192 + _e1213);
let _e1216 = select(_e1029, _e1214, (_e1214 < _e1029));
let _e1221 = global_2.member[bitcast<u32>(select(0i, _e1216, (_e1216 > 0i)))];
let _e1222 = bitcast<f32>(_e1221);
let _e1223 = local_4.member[3u];
let _e1224 = (_e1192 + _e1223);
let _e1226 = select(_e1029, _e1224, (_e1224 < _e1029));
let _e1231 = global_2.member[bitcast<u32>(select(0i, _e1226, (_e1226 > 0i)))];
let _e1233 = local_5[0u];
let _e1237 = local_5[0u];
let _e1240 = (_e1212 + ((_e1222 - _e1212) * _e1237));
let _e1241 = local_5[0u];
let _e1245 = (_e1010 + _e1005);
let _e1246 = local_4.member[1u];
let _e1247 = (_e1245 + _e1246);
let _e1249 = select(_e1029, _e1247, (_e1247 < _e1029));
let _e1254 = global_2.member[bitcast<u32>(select(0i, _e1249, (_e1249 > 0i)))];
let _e1255 = bitcast<f32>(_e1254);
let _e1256 = local_4.member[2u];
let _e1257 = (_e1245 + _e1256);
let _e1259 = select(_e1029, _e1257, (_e1257 < _e1029));
let _e1264 = global_2.member[bitcast<u32>(select(0i, _e1259, (_e1259 > 0i)))];
let _e1266 = local_5[0u];
let _e1269 = (_e1255 + ((bitcast<f32>(_e1264) - _e1255) * _e1266));
let _e1270 = (_e1010 + _e1008);
let _e1271 = local_4.member[1u];
let _e1272 = (_e1270 + _e1271);
let _e1274 = select(_e1029, _e1272, (_e1272 < _e1029));
let _e1279 = global_2.member[bitcast<u32>(select(0i, _e1274, (_e1274 > 0i)))];
let _e1280 = bitcast<f32>(_e1279);
let _e1281 = local_4.member[2u];
let _e1282 = (_e1270 + _e1281);
let _e1284 = select(_e1029, _e1282, (_e1282 < _e1029));
let _e1289 = global_2.member[bitcast<u32>(select(0i, _e1284, (_e1284 > 0i)))];
let _e1291 = local_5[0u];
let _e1295 = (_e1011 + _e1005);
let _e1296 = local_4.member[1u];
let _e1297 = (_e1295 + _e1296);
let _e1299 = select(_e1029, _e1297, (_e1297 < _e1029));
let _e1304 = global_2.member[bitcast<u32>(select(0i, _e1299, (_e1299 > 0i)))];
let _e1305 = bitcast<f32>(_e1304);
let _e1306 = local_4.member[2u];
let _e1307 = (_e1295 + _e1306);
let _e1309 = select(_e1029, _e1307, (_e1307 < _e1029));
let _e1314 = global_2.member[bitcast<u32>(select(0i, _e1309, (_e1309 > 0i)))];
let _e1316 = local_5[0u];
let _e1319 = (_e1305 + ((bitcast<f32>(_e1314) - _e1305) * _e1316));
let _e1320 = (_e1011 + _e1008);
let _e1321 = local_4.member[1u];
let _e1322 = (_e1320 + _e1321);
let _e1324 = select(_e1029, _e1322, (_e1322 < _e1029));
let _e1329 = global_2.member[bitcast<u32>(select(0i, _e1324, (_e1324 > 0i)))];
let _e1330 = bitcast<f32>(_e1329);
let _e1331 = local_4.member[2u];
let _e1332 = (_e1320 + _e1331);
let _e1334 = select(_e1029, _e1332, (_e1332 < _e1029));
let _e1339 = global_2.member[bitcast<u32>(select(0i, _e1334, (_e1334 > 0i)))];
let _e1341 = local_5[0u];
let _e1345 = (_e1009 + _e1006);
let _e1346 = local_4.member[1u];
let _e1347 = (_e1345 + _e1346);
let _e1349 = select(_e1029, _e1347, (_e1347 < _e1029));
let _e1354 = global_2.member[bitcast<u32>(select(0i, _e1349, (_e1349 > 0i)))];
let _e1355 = bitcast<f32>(_e1354);
let _e1356 = local_4.member[2u];
let _e1357 = (_e1345 + _e1356);
let _e1359 = select(_e1029, _e1357, (_e1357 < _e1029));
let _e1364 = global_2.member[bitcast<u32>(select(0i, _e1359, (_e1359 > 0i)))];
let _e1366 = local_5[0u];
let _e1369 = (_e1355 + ((bitcast<f32>(_e1364) - _e1355) * _e1366));
let _e1370 = (_e1012 + _e1006);
let _e1371 = local_4.member[1u];
let _e1372 = (_e1370 + _e1371);
let _e1374 = select(_e1029, _e1372, (_e1372 < _e1029));
let _e1379 = global_2.member[bitcast<u32>(select(0i, _e1374, (_e1374 > 0i)))];
let _e1380 = bitcast<f32>(_e1379);
let _e1381 = local_4.member[2u];
let _e1382 = (_e1370 + _e1381);
let _e1384 = select(_e1029, _e1382, (_e1382 < _e1029));
let _e1389 = global_2.member[bitcast<u32>(select(0i, _e1384, (_e1384 > 0i)))];
let _e1391 = local_5[0u];
let _e1394 = (_e1380 + ((bitcast<f32>(_e1389) - _e1380) * _e1391));
let _e1395 = (_e1009 + _e1007);
let _e1396 = local_4.member[1u];
let _e1397 = (_e1395 + _e1396);
let _e1399 = select(_e1029, _e1397, (_e1397 < _e1029));
let _e1404 = global_2.member[bitcast<u32>(select(0i, _e1399, (_e1399 > 0i)))];
let _e1405 = bitcast<f32>(_e1404);
let _e1406 = local_4.member[2u];
let _e1407 = (_e1395 + _e1406);
let _e1409 = select(_e1029, _e1407, (_e1407 < _e1029));
let _e1414 = global_2.member[bitcast<u32>(select(0i, _e1409, (_e1409 > 0i)))];
let _e1416 = local_5[0u];
let _e1420 = (_e1012 + _e1007);
let _e1421 = local_4.member[1u];
let _e1422 = (_e1420 + _e1421);
let _e1424 = select(_e1029, _e1422, (_e1422 < _e1029));
let _e1429 = global_2.member[bitcast<u32>(select(0i, _e1424, (_e1424 > 0i)))];
let _e1430 = bitcast<f32>(_e1429);
let _e1431 = local_4.member[2u];
let _e1432 = (_e1420 + _e1431);
let _e1434 = select(_e1029, _e1432, (_e1432 < _e1029));
let _e1439 = global_2.member[bitcast<u32>(select(0i, _e1434, (_e1434 > 0i)))];
let _e1441 = local_5[0u];
let _e1446 = local_5[1u];
let _e1449 = (_e1081 + ((_e1134 - _e1081) * _e1446));
let _e1450 = local_5[1u];
let _e1453 = (_e1187 + ((_e1240 - _e1187) * _e1450));
let _e1454 = local_5[1u];
let _e1457 = (_e1077 + (((_e1096 + ((_e1106 - _e1096) * _e1127)) - _e1077) * _e1454));
let _e1458 = local_5[1u];
let _e1463 = local_5[2u];
let _e1467 = local_5[1u];
let _e1470 = (_e1085 + (((_e1116 + ((bitcast<f32>(_e1125) - _e1116) * _e1135)) - _e1085) * _e1467));
let _e1471 = local_5[1u];
let _e1475 = local_5[2u];
let _e1479 = local_5[1u];
let _e1482 = (_e1269 + ((_e1081 - _e1269) * _e1479));
let _e1483 = local_5[1u];
let _e1487 = local_5[2u];
let _e1491 = local_5[1u];
let _e1494 = (_e1134 + (((_e1280 + ((bitcast<f32>(_e1289) - _e1280) * _e1291)) - _e1134) * _e1491));
let _e1495 = local_5[1u];
let _e1499 = local_5[2u];
let _e1503 = local_5[1u];
let _e1506 = (_e1369 + (((_e1405 + ((bitcast<f32>(_e1414) - _e1405) * _e1416)) - _e1369) * _e1503));
let _e1507 = local_5[2u];
let _e1511 = local_5[1u];
let _e1515 = local_5[2u];
let _e1519 = local_5[2u];
let _e1527 = global_1.member.member_5.member_4.member;
let _e1533 = global_1.member.member_5.member_4.member_1;
let _e1534 = (((_e1449 + ((_e1453 - _e1449) * _e1519)) * _e1527) + _e1533);
let _e1536 = select(0f, _e1534, (_e1534 > 0f));
let _e1538 = select(1f, _e1536, (_e1536 < 1f));
let _e1540 = (((_e1457 + (((_e1183 + (((_e1202 + ((_e1212 - _e1202) * _e1233)) - _e1183) * _e1458)) - _e1457) * _e1463)) * _e1527) + _e1533);
let _e1542 = select(0f, _e1540, (_e1540 > 0f));
let _e1544 = select(1f, _e1542, (_e1542 < 1f));
let _e1546 = (((_e1470 + (((_e1191 + (((_e1222 + ((bitcast<f32>(_e1231) - _e1222) * _e1241)) - _e1191) * _e1471)) - _e1470) * _e1475)) * _e1527) + _e1533);
let _e1548 = select(0f, _e1546, (_e1546 > 0f));
let _e1550 = select(1f, _e1548, (_e1548 < 1f));
let _e1552 = (((_e1482 + (((_e1319 + ((_e1187 - _e1319) * _e1483)) - _e1482) * _e1487)) * _e1527) + _e1533);
let _e1554 = select(0f, _e1552, (_e1552 > 0f));
let _e1556 = select(1f, _e1554, (_e1554 < 1f));
let _e1558 = (((_e1494 + (((_e1240 + (((_e1330 + ((bitcast<f32>(_e1339) - _e1330) * _e1341)) - _e1240) * _e1495)) - _e1494) * _e1499)) * _e1527) + _e1533);
let _e1560 = select(0f, _e1558, (_e1558 > 0f));
let _e1562 = select(1f, _e1560, (_e1560 < 1f));
let _e1564 = (((_e1506 + ((_e1449 - _e1506) * _e1507)) * _e1527) + _e1533);
let _e1566 = select(0f, _e1564, (_e1564 > 0f));
let _e1568 = select(1f, _e1566, (_e1566 < 1f));
let _e1570 = (((_e1453 + (((_e1394 + (((_e1430 + ((bitcast<f32>(_e1439) - _e1430) * _e1441)) - _e1394) * _e1511)) - _e1453) * _e1515)) * _e1527) + _e1533);
let _e1572 = select(0f, _e1570, (_e1570 > 0f));
let _e1574 = select(1f, _e1572, (_e1572 < 1f));
let _e1575 = (_e1538 * 1024f);
let _e1576 = (1024f - 1f);
let _e1578 = select(0f, _e1575, (_e1575 > 0f));
let _e1580 = select(_e1576, _e1578, (_e1578 < _e1576));
let _e1587 = select(0i, select(select(i32(_e1580), i32(-2147483648), (_e1580 < -2147483600f)), 2147483647i, (_e1580 > 2147483500f)), (_e1580 == _e1580));
let _e1591 = (_e1587 - select(0i, 1i, (_e1580 < f32(_e1587))));
let _e1592 = (262147i + _e1591);
let _e1594 = (bitcast<i32>(_e93) - 1i);
let _e1596 = select(_e1594, _e1592, (_e1592 < _e1594));
let _e1602 = global_4.member[bitcast<u32>(select(0i, _e1596, (_e1596 > 0i)))];
let _e1612 = select(_e1594, 262146i, (262146i < _e1594));
let _e1618 = global_4.member[bitcast<u32>(select(0i, _e1612, (_e1612 > 0i)))];
let _e1619 = bitcast<f32>(_e1618);
let _e1620 = (f32((bitcast<i32>((_e1602 & 4095u)) - 2048i)) * _e1619);
let _e1622 = select(_e1594, 262144i, (262144i < _e1594));
let _e1628 = global_4.member[bitcast<u32>(select(0i, _e1622, (_e1622 > 0i)))];
let _e1629 = bitcast<f32>(_e1628);
let _e1631 = select(_e1594, 262145i, (262145i < _e1594));
let _e1637 = global_4.member[bitcast<u32>(select(0i, _e1631, (_e1631 > 0i)))];
let _e1638 = bitcast<f32>(_e1637);
let _e1644 = ((_e1629 + (f32(bitcast<i32>((_e1602 >> bitcast<u32>(12u)))) * _e1638)) + (_e1620 * (_e1575 - f32(_e1591))));
let _e1645 = (_e1620 * 1024f);
if _e638 {
let _e1910 = ((0.5f * (_e1550 - _e1544)) * _e1645);
let _e1911 = ((0.5f * (_e1562 - _e1556)) * _e1645);
let _e1912 = ((0.5f * (_e1574 - _e1568)) * _e1645);
phi_5835_ = type_19(_e1644, vec3<f32>(_e1910, _e1911, _e1912), vec3<f32>((_e1910 * _e1644), (_e1911 * _e1644), (_e1912 * _e1644)));
} else {
let _e1646 = (_e1544 * 1024f);
let _e1648 = select(0f, _e1646, (_e1646 > 0f));
let _e1650 = select(_e1576, _e1648, (_e1648 < _e1576));
let _e1657 = select(0i, select(select(i32(_e1650), i32(-2147483648), (_e1650 < -2147483600f)), 2147483647i, (_e1650 > 2147483500f)), (_e1650 == _e1650));
let _e1661 = (_e1657 - select(0i, 1i, (_e1650 < f32(_e1657))));
let _e1662 = (262147i + _e1661);
let _e1664 = select(_e1594, _e1662, (_e1662 < _e1594));
let _e1670 = global_4.member[bitcast<u32>(select(0i, _e1664, (_e1664 > 0i)))];
let _e1685 = ((_e1629 + (f32(bitcast<i32>((_e1670 >> bitcast<u32>(12u)))) * _e1638)) + ((f32((bitcast<i32>((_e1670 & 4095u)) - 2048i)) * _e1619) * (_e1646 - f32(_e1661))));
let _e1686 = (_e1550 * 1024f);
let _e1688 = select(0f, _e1686, (_e1686 > 0f));
let _e1690 = select(_e1576, _e1688, (_e1688 < _e1576));
let _e1697 = select(0i, select(select(i32(_e1690), i32(-2147483648), (_e1690 < -2147483600f)), 2147483647i, (_e1690 > 2147483500f)), (_e1690 == _e1690));
let _e1701 = (_e1697 - select(0i, 1i, (_e1690 < f32(_e1697))));
let _e1702 = (262147i + _e1701);
let _e1704 = select(_e1594, _e1702, (_e1702 < _e1594));
let _e1710 = global_4.member[bitcast<u32>(select(0i, _e1704, (_e1704 > 0i)))];
let _e1725 = ((_e1629 + (f32(bitcast<i32>((_e1710 >> bitcast<u32>(12u)))) * _e1638)) + ((f32((bitcast<i32>((_e1710 & 4095u)) - 2048i)) * _e1619) * (_e1686 - f32(_e1701))));
let _e1726 = (_e1556 * 1024f);
let _e1728 = select(0f, _e1726, (_e1726 > 0f));
let _e1730 = select(_e1576, _e1728, (_e1728 < _e1576));
let _e1737 = select(0i, select(select(i32(_e1730), i32(-2147483648), (_e1730 < -2147483600f)), 2147483647i, (_e1730 > 2147483500f)), (_e1730 == _e1730));
let _e1741 = (_e1737 - select(0i, 1i, (_e1730 < f32(_e1737))));
let _e1742 = (262147i + _e1741);
let _e1744 = select(_e1594, _e1742, (_e1742 < _e1594));
let _e1750 = global_4.member[bitcast<u32>(select(0i, _e1744, (_e1744 > 0i)))];
let _e1765 = ((_e1629 + (f32(bitcast<i32>((_e1750 >> bitcast<u32>(12u)))) * _e1638)) + ((f32((bitcast<i32>((_e1750 & 4095u)) - 2048i)) * _e1619) * (_e1726 - f32(_e1741))));
let _e1766 = (_e1562 * 1024f);
let _e1768 = select(0f, _e1766, (_e1766 > 0f));
let _e1770 = select(_e1576, _e1768, (_e1768 < _e1576));
let _e1777 = select(0i, select(select(i32(_e1770), i32(-2147483648), (_e1770 < -2147483600f)), 2147483647i, (_e1770 > 2147483500f)), (_e1770 == _e1770));
let _e1781 = (_e1777 - select(0i, 1i, (_e1770 < f32(_e1777))));
let _e1782 = (262147i + _e1781);
let _e1784 = select(_e1594, _e1782, (_e1782 < _e1594));
let _e1790 = global_4.member[bitcast<u32>(select(0i, _e1784, (_e1784 > 0i)))];
let _e1805 = ((_e1629 + (f32(bitcast<i32>((_e1790 >> bitcast<u32>(12u)))) * _e1638)) + ((f32((bitcast<i32>((_e1790 & 4095u)) - 2048i)) * _e1619) * (_e1766 - f32(_e1781))));
let _e1806 = (_e1568 * 1024f);
let _e1808 = select(0f, _e1806, (_e1806 > 0f));
let _e1810 = select(_e1576, _e1808, (_e1808 < _e1576));
let _e1817 = select(0i, select(select(i32(_e1810), i32(-2147483648), (_e1810 < -2147483600f)), 2147483647i, (_e1810 > 2147483500f)), (_e1810 == _e1810));
let _e1821 = (_e1817 - select(0i, 1i, (_e1810 < f32(_e1817))));
let _e1822 = (262147i + _e1821);
let _e1824 = select(_e1594, _e1822, (_e1822 < _e1594));
let _e1830 = global_4.member[bitcast<u32>(select(0i, _e1824, (_e1824 > 0i)))];
let _e1845 = ((_e1629 + (f32(bitcast<i32>((_e1830 >> bitcast<u32>(12u)))) * _e1638)) + ((f32((bitcast<i32>((_e1830 & 4095u)) - 2048i)) * _e1619) * (_e1806 - f32(_e1821))));
let _e1846 = (_e1574 * 1024f);
let _e1848 = select(0f, _e1846, (_e1846 > 0f));
let _e1850 = select(_e1576, _e1848, (_e1848 < _e1576));
let _e1857 = select(0i, select(select(i32(_e1850), i32(-2147483648), (_e1850 < -2147483600f)), 2147483647i, (_e1850 > 2147483500f)), (_e1850 == _e1850));
let _e1861 = (_e1857 - select(0i, 1i, (_e1850 < f32(_e1857))));
let _e1862 = (262147i + _e1861);
let _e1864 = select(_e1594, _e1862, (_e1862 < _e1594));
let _e1870 = global_4.member[bitcast<u32>(select(0i, _e1864, (_e1864 > 0i)))];
let _e1885 = ((_e1629 + (f32(bitcast<i32>((_e1870 >> bitcast<u32>(12u)))) * _e1638)) + ((f32((bitcast<i32>((_e1870 & 4095u)) - 2048i)) * _e1619) * (_e1846 - f32(_e1861))));
let _e1886 = (_e1725 - _e1685);
let _e1888 = (_e1805 - _e1765);
let _e1890 = (_e1885 - _e1845);
phi_5835_ = type_19(_e1644, vec3<f32>((0.5f * _e1886), (0.5f * _e1888), (0.5f * _e1890)), vec3<f32>((0.25f * (_e1886 * (_e1725 + _e1685))), (0.25f * (_e1888 * (_e1805 + _e1765))), (0.25f * (_e1890 * (_e1885 + _e1845)))));
}
let _e1920 = phi_5835_;
let _e1935 = select(0f, 1f, ((((((_e440 >= -0.5f) && (_e440 <= _e463)) && (_e446 >= -0.5f)) && (_e446 <= _e473)) && (_e452 >= -0.5f)) && (_e452 <= _e483)));
let _e1937 = (0.5f * (_e1550 - _e1544));
let _e1939 = (0.5f * (_e1562 - _e1556));
let _e1941 = (0.5f * (_e1574 - _e1568));
let _e1946 = global_1.member.member_5.member.member;
let _e1952 = global_1.member.member_5.member_1.member;
let _e1959 = global_1.member.member_5.member_2.member;
let _e1966 = global_1.member.member_5.member.member_1;
let _e1972 = global_1.member.member_5.member_1.member_1;
let _e1979 = global_1.member.member_5.member_2.member_1;
let _e1986 = global_1.member.member_5.member.member_2;
let _e1992 = global_1.member.member_5.member_1.member_2;
let _e1999 = global_1.member.member_5.member_2.member_2;
phi_7155_ = type_20(_e1538, vec3<f32>(((((_e1946 * _e1937) + (_e1952 * _e1939)) + (_e1959 * _e1941)) * _e1935), ((((_e1966 * _e1937) + (_e1972 * _e1939)) + (_e1979 * _e1941)) * _e1935), ((((_e1986 * _e1937) + (_e1992 * _e1939)) + (_e1999 * _e1941)) * _e1935)), _e1920.member, vec3<f32>(((((_e1946 * _e1920.member_2.x) + (_e1952 * _e1920.member_2.y)) + (_e1959 * _e1920.member_2.z)) * _e1935), ((((_e1966 * _e1920.member_2.x) + (_e1972 * _e1920.member_2.y)) + (_e1979 * _e1920.member_2.z)) * _e1935), ((((_e1986 * _e1920.member_2.x) + (_e1992 * _e1920.member_2.y)) + (_e1999 * _e1920.member_2.z)) * _e1935)), vec3<f32>(((((_e1946 * _e1920.member_1.x) + (_e1952 * _e1920.member_1.y)) + (_e1959 * _e1920.member_1.z)) * _e1935), ((((_e1966 * _e1920.member_1.x) + (_e1972 * _e1920.member_1.y)) + (_e1979 * _e1920.member_1.z)) * _e1935), ((((_e1986 * _e1920.member_1.x) + (_e1992 * _e1920.member_1.y)) + (_e1999 * _e1920.member_1.z)) * _e1935)));
} else {
let _e643 = select(-1f, _e467, (_e467 > -1f));
let _e645 = select(_e462, _e643, (_e643 < _e462));
let _e652 = select(0i, select(select(i32(_e645), i32(-2147483648), (_e645 < -2147483600f)), 2147483647i, (_e645 > 2147483500f)), (_e645 == _e645));
let _e656 = (_e652 - select(0i, 1i, (_e645 < f32(_e652))));
let _e658 = select(-1f, _e477, (_e477 > -1f));
let _e660 = select(_e472, _e658, (_e658 < _e472));
let _e667 = select(0i, select(select(i32(_e660), i32(-2147483648), (_e660 < -2147483600f)), 2147483647i, (_e660 > 2147483500f)), (_e660 == _e660));
let _e671 = (_e667 - select(0i, 1i, (_e660 < f32(_e667))));
let _e673 = select(-1f, _e487, (_e487 > -1f));
let _e675 = select(_e482, _e673, (_e673 < _e482));
let _e682 = select(0i, select(select(i32(_e675), i32(-2147483648), (_e675 < -2147483600f)), 2147483647i, (_e675 > 2147483500f)), (_e675 == _e675));
let _e686 = (_e682 - select(0i, 1i, (_e675 < f32(_e682))));
let _e691 = global_1.member.member_5.member_5[0u];
let _e696 = global_1.member.member_5.member_5[1u];
let _e704 = (select(0i, select(select(i32(_e472), i32(-2147483648), (_e472 < -2147483600f)), 2147483647i, (_e472 > 2147483500f)), (_e472 == _e472)) - 1i);
let _e707 = (_e671 + 1i);
let _e717 = (select(0i, select(select(i32(_e482), i32(-2147483648), (_e482 < -2147483600f)), 2147483647i, (_e482 > 2147483500f)), (_e482 == _e482)) - 1i);
let _e720 = (_e686 + 1i);
let _e730 = (select(0i, select(select(i32(_e462), i32(-2147483648), (_e462 < -2147483600f)), 2147483647i, (_e462 > 2147483500f)), (_e462 == _e462)) - 1i);
let _e731 = (_e656 - 1i);
let _e736 = (_e656 + 1i);
let _e739 = (_e656 + 2i);
let _e742 = (select(0i, _e671, (_e671 > 0i)) * _e691);
let _e743 = (select(_e704, _e707, (_e707 < _e704)) * _e691);
let _e744 = (select(0i, _e686, (_e686 > 0i)) * _e696);
let _e745 = (select(_e717, _e720, (_e720 < _e717)) * _e696);
local_2 = type_18(array<i32, 4>(select(0i, _e731, (_e731 > 0i)), select(0i, _e656, (_e656 > 0i)), select(_e730, _e736, (_e736 < _e730)), select(_e730, _e739, (_e739 < _e730))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_3 = vec3<f32>((_e467 - f32(_e656)), (_e477 - f32(_e671)), (_e487 - f32(_e686)));
let _e756 = (_e744 + _e742);
let _e759 = local_2.member[1u];
let _e760 = (_e756 + _e759);
let _e762 = (bitcast<i32>(_e89) - 1i);
let _e764 = select(_e762, _e760, (_e760 < _e762));
let _e769 = global_2.member[bitcast<u32>(select(0i, _e764, (_e764 > 0i)))];
let _e770 = bitcast<f32>(_e769);
let _e773 = local_2.member[2u];
let _e774 = (_e756 + _e773);
let _e776 = select(_e762, _e774, (_e774 < _e762));
let _e781 = global_2.member[bitcast<u32>(select(0i, _e776, (_e776 > 0i)))];
let _e783 = local_3[0u];
let _e786 = (_e770 + ((bitcast<f32>(_e781) - _e770) * _e783));
let _e787 = (_e744 + _e743);
let _e788 = local_2.member[1u];
let _e789 = (_e787 + _e788);
let _e791 = select(_e762, _e789, (_e789 < _e762));
let _e796 = global_2.member[bitcast<u32>(select(0i, _e791, (_e791 > 0i)))];
let _e797 = bitcast<f32>(_e796);
let _e798 = local_2.member[2u];
let _e799 = (_e787 + _e798);
let _e801 = select(_e762, _e799, (_e799 < _e762));
let _e806 = global_2.member[bitcast<u32>(select(0i, _e801, (_e801 > 0i)))];
let _e808 = local_3[0u];
let _e813 = local_3[1u];
let _e816 = (_e786 + (((_e797 + ((bitcast<f32>(_e806) - _e797) * _e808)) - _e786) * _e813));
let _e817 = (_e745 + _e742);
let _e818 = local_2.member[1u];
let _e819 = (_e817 + _e818);
let _e821 = select(_e762, _e819, (_e819 < _e762));
let _e826 = global_2.member[bitcast<u32>(select(0i, _e821, (_e821 > 0i)))];
let _e827 = bitcast<f32>(_e826);
let _e828 = local_2.member[2u];
let _e829 = (_e817 + _e828);
let _e831 = select(_e762, _e829, (_e829 < _e762));
let _e836 = global_2.member[bitcast<u32>(select(0i, _e831, (_e831 > 0i)))];
let _e838 = local_3[0u];
let _e841 = (_e827 + ((bitcast<f32>(_e836) - _e827) * _e838));
let _e842 = (_e745 + _e743);
let _e843 = local_2.member[1u];
let _e844 = (_e842 + _e843);
let _e846 = select(_e762, _e844, (_e844 < _e762));
let _e851 = global_2.member[bitcast<u32>(select(0i, _e846, (_e846 > 0i)))];
let _e852 = bitcast<f32>(_e851);
let _e853 = local_2.member[2u];
let _e854 = (_e842 + _e853);
let _e856 = select(_e762, _e854, (_e854 < _e762));
let _e861 = global_2.member[bitcast<u32>(select(0i, _e856, (_e856 > 0i)))];
let _e863 = local_3[0u];
let _e867 = local_3[1u];
let _e872 = local_3[2u];
let _e880 = global_1.member.member_5.member_4.member;
let _e886 = global_1.member.member_5.member_4.member_1;
let _e887 = (((_e816 + (((_e841 + (((_e852 + ((bitcast<f32>(_e861) - _e852) * _e863)) - _e841) * _e867)) - _e816) * _e872)) * _e880) + _e886);
let _e889 = select(0f, _e887, (_e887 > 0f));
phi_7155_ = type_20(select(1f, _e889, (_e889 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2052 = phi_7155_;
let _e2054 = select(-0.5f, _e398, (_e398 > -0.5f));
let _e2056 = select(_e463, _e2054, (_e2054 < _e463));
let _e2058 = select(-0.5f, _e416, (_e416 > -0.5f));
let _e2060 = select(_e473, _e2058, (_e2058 < _e473));
let _e2062 = select(-0.5f, _e434, (_e434 > -0.5f));
let _e2064 = select(_e483, _e2062, (_e2062 < _e483));
let _e2066 = select(-1f, _e2056, (_e2056 > -1f));
let _e2068 = select(_e462, _e2066, (_e2066 < _e462));
let _e2075 = select(0i, select(select(i32(_e2068), i32(-2147483648), (_e2068 < -2147483600f)), 2147483647i, (_e2068 > 2147483500f)), (_e2068 == _e2068));
let _e2079 = (_e2075 - select(0i, 1i, (_e2068 < f32(_e2075))));
let _e2081 = select(-1f, _e2060, (_e2060 > -1f));
let _e2083 = select(_e472, _e2081, (_e2081 < _e472));
let _e2090 = select(0i, select(select(i32(_e2083), i32(-2147483648), (_e2083 < -2147483600f)), 2147483647i, (_e2083 > 2147483500f)), (_e2083 == _e2083));
let _e2094 = (_e2090 - select(0i, 1i, (_e2083 < f32(_e2090))));
let _e2096 = select(-1f, _e2064, (_e2064 > -1f));
let _e2098 = select(_e482, _e2096, (_e2096 < _e482));
let _e2105 = select(0i, select(select(i32(_e2098), i32(-2147483648), (_e2098 < -2147483600f)), 2147483647i, (_e2098 > 2147483500f)), (_e2098 == _e2098));
let _e2109 = (_e2105 - select(0i, 1i, (_e2098 < f32(_e2105))));
let _e2114 = global_1.member.member_5.member_5[0u];
let _e2119 = global_1.member.member_5.member_5[1u];
let _e2127 = (select(0i, select(select(i32(_e472), i32(-2147483648), (_e472 < -2147483600f)), 2147483647i, (_e472 > 2147483500f)), (_e472 == _e472)) - 1i);
let _e2130 = (_e2094 + 1i);
let _e2140 = (select(0i, select(select(i32(_e482), i32(-2147483648), (_e482 < -2147483600f)), 2147483647i, (_e482 > 2147483500f)), (_e482 == _e482)) - 1i);
let _e2143 = (_e2109 + 1i);
let _e2153 = (select(0i, select(select(i32(_e462), i32(-2147483648), (_e462 < -2147483600f)), 2147483647i, (_e462 > 2147483500f)), (_e462 == _e462)) - 1i);
let _e2154 = (_e2079 - 1i);
let _e2159 = (_e2079 + 1i);
let _e2162 = (_e2079 + 2i);
let _e2165 = (select(0i, _e2094, (_e2094 > 0i)) * _e2114);
let _e2166 = (select(_e2127, _e2130, (_e2130 < _e2127)) * _e2114);
let _e2167 = (select(0i, _e2109, (_e2109 > 0i)) * _e2119);
let _e2168 = (select(_e2140, _e2143, (_e2143 < _e2140)) * _e2119);
local = type_18(array<i32, 4>(select(0i, _e2154, (_e2154 > 0i)), select(0i, _e2079, (_e2079 > 0i)), select(_e2153, _e2159, (_e2159 < _e2153)), select(_e2153, _e2162, (_e2162 < _e2153))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_1 = vec3<f32>((_e2056 - f32(_e2079)), (_e2060 - f32(_e2094)), (_e2064 - f32(_e2109)));
let _e2179 = (_e2167 + _e2165);
let _e2182 = local.member[1u];
let _e2183 = (_e2179 + _e2182);
let _e2185 = (bitcast<i32>(_e89) - 1i);
let _e2187 = select(_e2185, _e2183, (_e2183 < _e2185));
let _e2192 = global_2.member[bitcast<u32>(select(0i, _e2187, (_e2187 > 0i)))];
let _e2193 = bitcast<f32>(_e2192);
let _e2196 = local.member[2u];
let _e2197 = (_e2179 + _e2196);
let _e2199 = select(_e2185, _e2197, (_e2197 < _e2185));
let _e2204 = global_2.member[bitcast<u32>(select(0i, _e2199, (_e2199 > 0i)))];
let _e2206 = local_1[0u];
let _e2209 = (_e2193 + ((bitcast<f32>(_e2204) - _e2193) * _e2206));
let _e2210 = (_e2167 + _e2166);
let _e2211 = local.member[1u];
let _e2212 = (_e2210 + _e2211);
let _e2214 = select(_e2185, _e2212, (_e2212 < _e2185));
let _e2219 = global_2.member[bitcast<u32>(select(0i, _e2214, (_e2214 > 0i)))];
let _e2220 = bitcast<f32>(_e2219);
let _e2221 = local.member[2u];
let _e2222 = (_e2210 + _e2221);
let _e2224 = select(_e2185, _e2222, (_e2222 < _e2185));
let _e2229 = global_2.member[bitcast<u32>(select(0i, _e2224, (_e2224 > 0i)))];
let _e2231 = local_1[0u];
let _e2236 = local_1[1u];
let _e2239 = (_e2209 + (((_e2220 + ((bitcast<f32>(_e2229) - _e2220) * _e2231)) - _e2209) * _e2236));
let _e2240 = (_e2168 + _e2165);
let _e2241 = local.member[1u];
let _e2242 = (_e2240 + _e2241);
let _e2244 = select(_e2185, _e2242, (_e2242 < _e2185));
let _e2249 = global_2.member[bitcast<u32>(select(0i, _e2244, (_e2244 > 0i)))];
let _e2250 = bitcast<f32>(_e2249);
let _e2251 = local.member[2u];
let _e2252 = (_e2240 + _e2251);
let _e2254 = select(_e2185, _e2252, (_e2252 < _e2185));
let _e2259 = global_2.member[bitcast<u32>(select(0i, _e2254, (_e2254 > 0i)))];
let _e2261 = local_1[0u];
let _e2264 = (_e2250 + ((bitcast<f32>(_e2259) - _e2250) * _e2261));
let _e2265 = (_e2168 + _e2166);
let _e2266 = local.member[1u];
let _e2267 = (_e2265 + _e2266);
let _e2269 = select(_e2185, _e2267, (_e2267 < _e2185));
let _e2274 = global_2.member[bitcast<u32>(select(0i, _e2269, (_e2269 > 0i)))];
let _e2275 = bitcast<f32>(_e2274);
let _e2276 = local.member[2u];
let _e2277 = (_e2265 + _e2276);
let _e2279 = select(_e2185, _e2277, (_e2277 < _e2185));
let _e2284 = global_2.member[bitcast<u32>(select(0i, _e2279, (_e2279 > 0i)))];
let _e2286 = local_1[0u];
let _e2290 = local_1[1u];
let _e2295 = local_1[2u];
let _e2303 = global_1.member.member_5.member_4.member;
let _e2309 = global_1.member.member_5.member_4.member_1;
let _e2310 = (((_e2239 + (((_e2264 + (((_e2275 + ((bitcast<f32>(_e2284) - _e2275) * _e2286)) - _e2264) * _e2290)) - _e2239) * _e2295)) * _e2303) + _e2309);
let _e2312 = select(0f, _e2310, (_e2310 > 0f));
if ((_e621 & 16u) == 0u) {
phi_8676_ = type_21(1f, 1f, 1f);
} else {
let _e2319 = global_1.member.member_18;
let _e2323 = global_1.member.member_22.member;
let _e2333 = ((((_e2319.member * _e306) + (_e2319.member_1 * _e315)) + (_e2319.member_2 * _e288)) + _e2319.member_3);
let _e2339 = ((((_e2319.member * _e327) + (_e2319.member_1 * _e332)) + (_e2319.member_2 * _e321)) + _e2319.member_3);
let _e2341 = select(_e2339, _e2333, (_e2333 < _e2339));
let _e2343 = select(_e2339, _e2333, (_e2333 > _e2339));
let _e2345 = (_e2343 - _e2341);
let _e2348 = (-(_e2341) / select(1e-30f, _e2345, (_e2345 > 1e-30f)));
let _e2350 = select(0f, _e2348, (_e2348 > 0f));
let _e2356 = select(select(select(1f, _e2350, (_e2350 < 1f)), 1f, (_e2343 <= 0f)), 0f, (_e2341 > 0f));
let _e2358 = (_e2323 > 0.5f);
let _e2367 = global_1.member.member_19;
let _e2371 = global_1.member.member_22.member_1;
let _e2381 = ((((_e2367.member * _e306) + (_e2367.member_1 * _e315)) + (_e2367.member_2 * _e288)) + _e2367.member_3);
let _e2387 = ((((_e2367.member * _e327) + (_e2367.member_1 * _e332)) + (_e2367.member_2 * _e321)) + _e2367.member_3);
let _e2389 = select(_e2387, _e2381, (_e2381 < _e2387));
let _e2391 = select(_e2387, _e2381, (_e2381 > _e2387));
let _e2393 = (_e2391 - _e2389);
let _e2396 = (-(_e2389) / select(1e-30f, _e2393, (_e2393 > 1e-30f)));
let _e2398 = select(0f, _e2396, (_e2396 > 0f));
let _e2404 = select(select(select(1f, _e2398, (_e2398 < 1f)), 1f, (_e2391 <= 0f)), 0f, (_e2389 > 0f));
let _e2406 = (_e2371 > 0.5f);
let _e2415 = global_1.member.member_20;
let _e2419 = global_1.member.member_22.member_2;
let _e2429 = ((((_e2415.member * _e306) + (_e2415.member_1 * _e315)) + (_e2415.member_2 * _e288)) + _e2415.member_3);
let _e2435 = ((((_e2415.member * _e327) + (_e2415.member_1 * _e332)) + (_e2415.member_2 * _e321)) + _e2415.member_3);
let _e2437 = select(_e2435, _e2429, (_e2429 < _e2435));
let _e2439 = select(_e2435, _e2429, (_e2429 > _e2435));
let _e2441 = (_e2439 - _e2437);
let _e2444 = (-(_e2437) / select(1e-30f, _e2441, (_e2441 > 1e-30f)));
let _e2446 = select(0f, _e2444, (_e2444 > 0f));
let _e2452 = select(select(select(1f, _e2446, (_e2446 < 1f)), 1f, (_e2439 <= 0f)), 0f, (_e2437 > 0f));
let _e2454 = (_e2419 > 0.5f);
let _e2463 = global_1.member.member_21;
let _e2467 = global_1.member.member_22.member_3;
let _e2477 = ((((_e2463.member * _e306) + (_e2463.member_1 * _e315)) + (_e2463.member_2 * _e288)) + _e2463.member_3);
let _e2483 = ((((_e2463.member * _e327) + (_e2463.member_1 * _e332)) + (_e2463.member_2 * _e321)) + _e2463.member_3);
let _e2485 = select(_e2483, _e2477, (_e2477 < _e2483));
let _e2487 = select(_e2483, _e2477, (_e2477 > _e2483));
let _e2489 = (_e2487 - _e2485);
let _e2492 = (-(_e2485) / select(1e-30f, _e2489, (_e2489 > 1e-30f)));
let _e2494 = select(0f, _e2492, (_e2492 > 0f));
let _e2500 = select(select(select(1f, _e2494, (_e2494 < 1f)), 1f, (_e2487 <= 0f)), 0f, (_e2485 > 0f));
let _e2502 = (_e2467 > 0.5f);
phi_8676_ = type_21(((((1f * _e2356) * _e2404) * _e2452) * _e2500), ((((1f * select(1f, _e2356, _e2358)) * select(1f, _e2404, _e2406)) * select(1f, _e2452, _e2454)) * select(1f, _e2500, _e2502)), ((((1f * select(1f, 0f, (_e2358 && (_e2339 > 0f)))) * select(1f, 0f, (_e2406 && (_e2387 > 0f)))) * select(1f, 0f, (_e2454 && (_e2435 > 0f)))) * select(1f, 0f, (_e2502 && (_e2483 > 0f)))));
}
let _e2511 = phi_8676_;
let _e2512 = (_e327 - _e306);
let _e2513 = (_e332 - _e315);
let _e2514 = (_e321 - _e288);
let _e2519 = (((_e2512 * _e2512) + (_e2513 * _e2513)) + (_e2514 * _e2514));
let _e2523 = (_e493 < 1e-12f);
let _e2525 = (1f / select(_e488, 1f, _e2523));
let _e2527 = ((-0.5f - _e398) * _e2525);
let _e2529 = ((_e463 - _e398) * _e2525);
let _e2535 = select(_e2529, _e2527, (_e2527 < _e2529));
let _e2537 = select(0f, _e2535, (_e2535 > 0f));
let _e2540 = select(select(1f, _e2537, (_e2537 < 1f)), select(2f, 0f, ((_e398 >= -0.5f) && (_e398 <= _e463))), _e2523);
let _e2542 = select(_e2529, _e2527, (_e2527 > _e2529));
let _e2544 = select(0f, _e2542, (_e2542 > 0f));
let _e2547 = select(select(1f, _e2544, (_e2544 < 1f)), 1f, _e2523);
let _e2548 = (_e496 < 1e-12f);
let _e2550 = (1f / select(_e489, 1f, _e2548));
let _e2552 = ((-0.5f - _e416) * _e2550);
let _e2554 = ((_e473 - _e416) * _e2550);
let _e2560 = select(_e2554, _e2552, (_e2552 < _e2554));
let _e2562 = select(0f, _e2560, (_e2560 > 0f));
let _e2565 = select(select(1f, _e2562, (_e2562 < 1f)), select(2f, 0f, ((_e416 >= -0.5f) && (_e416 <= _e473))), _e2548);
let _e2567 = select(_e2554, _e2552, (_e2552 > _e2554));
let _e2569 = select(0f, _e2567, (_e2567 > 0f));
let _e2572 = select(select(1f, _e2569, (_e2569 < 1f)), 1f, _e2548);
let _e2573 = (_e501 < 1e-12f);
let _e2575 = (1f / select(_e490, 1f, _e2573));
let _e2577 = ((-0.5f - _e434) * _e2575);
let _e2579 = ((_e483 - _e434) * _e2575);
let _e2585 = select(_e2579, _e2577, (_e2577 < _e2579));
let _e2587 = select(0f, _e2585, (_e2585 > 0f));
let _e2590 = select(select(1f, _e2587, (_e2587 < 1f)), select(2f, 0f, ((_e434 >= -0.5f) && (_e434 <= _e483))), _e2573);
let _e2592 = select(_e2579, _e2577, (_e2577 > _e2579));
let _e2594 = select(0f, _e2592, (_e2592 > 0f));
let _e2597 = select(select(1f, _e2594, (_e2594 < 1f)), 1f, _e2573);
let _e2599 = select(_e2572, _e2547, (_e2547 < _e2572));
let _e2603 = select(_e2565, _e2540, (_e2540 > _e2565));
let _e2606 = (select(_e2597, _e2599, (_e2599 < _e2597)) - select(_e2590, _e2603, (_e2603 > _e2590)));
let _e2613 = global_1.member.member_4.member_3;
let _e2614 = ((sqrt(select(0f, _e2519, (_e2519 > 0f))) * select(0f, _e2606, (_e2606 > 0f))) * _e2613);
let _e2616 = (select(1f, _e2312, (_e2312 < 1f)) * 255f);
let _e2617 = (_e2052.member * 255f);
let _e2618 = (255f - 1f);
let _e2620 = select(0f, _e2616, (_e2616 > 0f));
let _e2622 = select(_e2618, _e2620, (_e2620 < _e2618));
let _e2629 = select(0i, select(select(i32(_e2622), i32(-2147483648), (_e2622 < -2147483600f)), 2147483647i, (_e2622 > 2147483500f)), (_e2622 == _e2622));
let _e2633 = (_e2629 - select(0i, 1i, (_e2622 < f32(_e2629))));
let _e2635 = select(0f, _e2617, (_e2617 > 0f));
let _e2637 = select(_e2618, _e2635, (_e2635 < _e2618));
let _e2644 = select(0i, select(select(i32(_e2637), i32(-2147483648), (_e2637 < -2147483600f)), 2147483647i, (_e2637 > 2147483500f)), (_e2637 == _e2637));
let _e2648 = (_e2644 - select(0i, 1i, (_e2637 < f32(_e2644))));
let _e2651 = (((_e2633 * 256i) + _e2648) * 4i);
let _e2653 = (_e2616 - f32(_e2633));
let _e2655 = (_e2617 - f32(_e2648));
let _e2657 = (bitcast<i32>(_e93) - 1i);
let _e2659 = select(_e2657, _e2651, (_e2651 < _e2657));
let _e2665 = global_4.member[bitcast<u32>(select(0i, _e2659, (_e2659 > 0i)))];
let _e2666 = (_e2651 + 4i);
let _e2668 = select(_e2657, _e2666, (_e2666 < _e2657));
let _e2674 = global_4.member[bitcast<u32>(select(0i, _e2668, (_e2668 > 0i)))];
let _e2675 = (_e2651 + 1024i);
let _e2677 = select(_e2657, _e2675, (_e2675 < _e2657));
let _e2683 = global_4.member[bitcast<u32>(select(0i, _e2677, (_e2677 > 0i)))];
let _e2684 = (_e2651 + 1028i);
let _e2686 = select(_e2657, _e2684, (_e2684 < _e2657));
let _e2692 = global_4.member[bitcast<u32>(select(0i, _e2686, (_e2686 > 0i)))];
let _e2697 = (bitcast<f32>(((_e2665 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2705 = (_e2697 + (((bitcast<f32>(((_e2674 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2697) * _e2655));
let _e2710 = (bitcast<f32>(((_e2683 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2734 = (bitcast<f32>((((_e2665 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2742 = (_e2734 + (((bitcast<f32>((((_e2674 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2734) * _e2655));
let _e2747 = (bitcast<f32>((((_e2683 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2759 = (_e2651 + 1i);
let _e2761 = select(_e2657, _e2759, (_e2759 < _e2657));
let _e2767 = global_4.member[bitcast<u32>(select(0i, _e2761, (_e2761 > 0i)))];
let _e2768 = (_e2651 + 5i);
let _e2770 = select(_e2657, _e2768, (_e2768 < _e2657));
let _e2776 = global_4.member[bitcast<u32>(select(0i, _e2770, (_e2770 > 0i)))];
let _e2777 = (_e2651 + 1025i);
let _e2779 = select(_e2657, _e2777, (_e2777 < _e2657));
let _e2785 = global_4.member[bitcast<u32>(select(0i, _e2779, (_e2779 > 0i)))];
let _e2786 = (_e2651 + 1029i);
let _e2788 = select(_e2657, _e2786, (_e2786 < _e2657));
let _e2794 = global_4.member[bitcast<u32>(select(0i, _e2788, (_e2788 > 0i)))];
let _e2799 = (bitcast<f32>(((_e2767 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2807 = (_e2799 + (((bitcast<f32>(((_e2776 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2799) * _e2655));
let _e2812 = (bitcast<f32>(((_e2785 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2836 = (bitcast<f32>((((_e2767 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2844 = (_e2836 + (((bitcast<f32>((((_e2776 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2836) * _e2655));
let _e2849 = (bitcast<f32>((((_e2785 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2864 = (_e2614 * _e2511.member_1);
let _e2866 = -(((_e2742 + (((_e2747 + (((bitcast<f32>((((_e2692 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2747) * _e2655)) - _e2742) * _e2653)) * _e2864));
let _e2868 = select(-87f, _e2866, (_e2866 > -87f));
let _e2870 = select(88f, _e2868, (_e2868 < 88f));
let _e2872 = ((_e2870 * 1.442695f) + 0.5f);
let _e2874 = select(-127f, _e2872, (_e2872 > -127f));
let _e2876 = select(128f, _e2874, (_e2874 < 128f));
let _e2883 = select(0i, select(select(i32(_e2876), i32(-2147483648), (_e2876 < -2147483600f)), 2147483647i, (_e2876 > 2147483500f)), (_e2876 == _e2876));
let _e2887 = (_e2883 - select(0i, 1i, (_e2876 < f32(_e2883))));
let _e2888 = f32(_e2887);
let _e2892 = ((_e2870 - (_e2888 * 0.6933594f)) - (_e2888 * -2.1219444e-4f));
let _e2914 = -(((_e2807 + (((_e2812 + (((bitcast<f32>(((_e2794 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2812) * _e2655)) - _e2807) * _e2653)) * _e2864));
let _e2916 = select(-87f, _e2914, (_e2914 > -87f));
let _e2918 = select(88f, _e2916, (_e2916 < 88f));
let _e2920 = ((_e2918 * 1.442695f) + 0.5f);
let _e2922 = select(-127f, _e2920, (_e2920 > -127f));
let _e2924 = select(128f, _e2922, (_e2922 < 128f));
let _e2931 = select(0i, select(select(i32(_e2924), i32(-2147483648), (_e2924 < -2147483600f)), 2147483647i, (_e2924 > 2147483500f)), (_e2924 == _e2924));
let _e2935 = (_e2931 - select(0i, 1i, (_e2924 < f32(_e2931))));
let _e2936 = f32(_e2935);
let _e2940 = ((_e2918 - (_e2936 * 0.6933594f)) - (_e2936 * -2.1219444e-4f));
let _e2962 = -(((_e2844 + (((_e2849 + (((bitcast<f32>((((_e2794 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2849) * _e2655)) - _e2844) * _e2653)) * _e2864));
let _e2964 = select(-87f, _e2962, (_e2962 > -87f));
let _e2966 = select(88f, _e2964, (_e2964 < 88f));
let _e2968 = ((_e2966 * 1.442695f) + 0.5f);
let _e2970 = select(-127f, _e2968, (_e2968 > -127f));
let _e2972 = select(128f, _e2970, (_e2970 < 128f));
let _e2979 = select(0i, select(select(i32(_e2972), i32(-2147483648), (_e2972 < -2147483600f)), 2147483647i, (_e2972 > 2147483500f)), (_e2972 == _e2972));
let _e2983 = (_e2979 - select(0i, 1i, (_e2972 < f32(_e2979))));
let _e2984 = f32(_e2983);
let _e2988 = ((_e2966 - (_e2984 * 0.6933594f)) - (_e2984 * -2.1219444e-4f));
let _e3010 = -(((_e2705 + (((_e2710 + (((bitcast<f32>(((_e2692 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2710) * _e2655)) - _e2705) * _e2653)) * (_e2614 * _e2511.member)));
let _e3012 = select(-87f, _e3010, (_e3010 > -87f));
let _e3014 = select(88f, _e3012, (_e3012 < 88f));
let _e3016 = ((_e3014 * 1.442695f) + 0.5f);
let _e3018 = select(-127f, _e3016, (_e3016 > -127f));
let _e3020 = select(128f, _e3018, (_e3018 < 128f));
let _e3027 = select(0i, select(select(i32(_e3020), i32(-2147483648), (_e3020 < -2147483600f)), 2147483647i, (_e3020 > 2147483500f)), (_e3020 == _e3020));
let _e3031 = (_e3027 - select(0i, 1i, (_e3020 < f32(_e3027))));
let _e3032 = f32(_e3031);
let _e3036 = ((_e3014 - (_e3032 * 0.6933594f)) - (_e3032 * -2.1219444e-4f));
let _e3056 = ((1f + (_e3036 * (1f + (_e3036 * (0.5f + (_e3036 * (0.16666667f + (_e3036 * (0.041666668f + (_e3036 * (0.008333334f + (_e3036 * (0.001388889f + (_e3036 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3031 + 127i)) << bitcast<u32>(23i))));
if _e641 {
let _e3071 = global_1.member.member_24.member_2;
let _e3074 = (_e2052.member_3.x * _e2511.member_2);
let _e3076 = (_e2052.member_3.y * _e2511.member_2);
let _e3078 = (_e2052.member_3.z * _e2511.member_2);
let _e3079 = (0.5f * (_e245 / _e197));
let _e3083 = (_e175 + (_e3074 * _e3079));
let _e3084 = (_e186 + (_e3076 * _e3079));
let _e3085 = (_e197 + (_e3078 * _e3079));
let _e3087 = (2f * _e245);
let _e3089 = ((_e3085 * _e3085) + (_e3087 * _e3078));
let _e3093 = (_e3085 + sqrt(select(0f, _e3089, (_e3089 > 0f))));
let _e3097 = (0.5f * (_e3087 / select(1e-6f, _e3093, (_e3093 > 1e-6f))));
let _e3101 = (_e3083 + (_e3074 * _e3097));
let _e3102 = (_e3084 + (_e3076 * _e3097));
let _e3103 = (_e3085 + (_e3078 * _e3097));
let _e3107 = (_e3071 * _e3071);
let _e3109 = (_e3103 * _e3103);
let _e3117 = (((_e3085 <= 0f) || (_e3089 <= 0f)) || ((_e3103 <= 0f) || (_e3109 <= (_e3107 * (((_e3101 * _e3101) + (_e3102 * _e3102)) + _e3109)))));
let _e3131 = (_e175 + ((_e2052.member_4.x * _e2511.member_2) * _e245));
let _e3132 = (_e186 + ((_e2052.member_4.y * _e2511.member_2) * _e245));
let _e3133 = (_e197 + ((_e2052.member_4.z * _e2511.member_2) * _e245));
let _e3135 = (_e3133 * _e3133);
let _e3144 = ((_e621 & 1u) != 0u);
phi_9700_ = select(select(select(_e3103, _e3085, _e3117), _e3133, _e3144), _e197, _e628);
phi_9701_ = select(select(select(_e3102, _e3084, _e3117), _e3132, _e3144), _e186, _e628);
phi_9702_ = select(select(select(_e3101, _e3083, _e3117), _e3131, _e3144), _e175, _e628);
phi_9703_ = (select(_e3117, ((_e3133 <= 0f) || (_e3135 <= (_e3107 * (((_e3131 * _e3131) + (_e3132 * _e3132)) + _e3135)))), _e3144) && !(_e628));
} else {
phi_9700_ = _e197;
phi_9701_ = _e186;
phi_9702_ = _e175;
phi_9703_ = false;
}
let _e3155 = phi_9700_;
let _e3157 = phi_9701_;
let _e3159 = phi_9702_;
let _e3161 = phi_9703_;
global_6.member[_e121] = (_e132 + _e260);
global_6.member[_e133] = (_e142 + _e267);
global_6.member[_e144] = (_e153 + _e369);
global_6.member[_e155] = (_e164 + _e372);
global_6.member[_e166] = _e3159;
global_6.member[_e177] = _e3157;
global_6.member[_e188] = _e3155;
global_6.member[_e199] = select((_e208 * (((1f + (_e2892 * (1f + (_e2892 * (0.5f + (_e2892 * (0.16666667f + (_e2892 * (0.041666668f + (_e2892 * (0.008333334f + (_e2892 * (0.001388889f + (_e2892 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2887 + 127i)) << bitcast<u32>(23i)))) * _e3056)), _e208, _e628);
global_6.member[_e210] = select((_e219 * (((1f + (_e2940 * (1f + (_e2940 * (0.5f + (_e2940 * (0.16666667f + (_e2940 * (0.041666668f + (_e2940 * (0.008333334f + (_e2940 * (0.001388889f + (_e2940 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2935 + 127i)) << bitcast<u32>(23i)))) * _e3056)), _e219, _e628);
global_6.member[_e221] = select((_e230 * (((1f + (_e2988 * (1f + (_e2988 * (0.5f + (_e2988 * (0.16666667f + (_e2988 * (0.041666668f + (_e2988 * (0.008333334f + (_e2988 * (0.001388889f + (_e2988 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2983 + 127i)) << bitcast<u32>(23i)))) * _e3056)), _e230, _e628);
global_6.member[_e232] = select(_e241, 1f, _e3161);
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

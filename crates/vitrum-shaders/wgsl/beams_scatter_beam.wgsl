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
struct type_12 {
member: type_5,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
}
struct type_13 {
member: u32,
member_1: u32,
}
struct type_15 {
member: array<f32>,
}
struct type_18 {
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
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
member_12: u32,
member_13: u32,
member_14: f32,
member_15: f32,
member_16: f32,
}
struct type_20 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
}
struct type_21 {
member: f32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
}
struct type_22 {
member: type_5,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_23 {
member: type_2,
member_1: type_13,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_18,
member_12: type_19,
member_13: type_20,
member_14: type_9,
member_15: type_6,
member_16: type_12,
member_17: u32,
member_18: type_21,
member_19: type_22,
}
struct type_24 {
member: type_23,
}
struct type_25 {
member: f32,
member_1: f32,
}
struct type_26 {
member: i32,
member_1: i32,
}
struct type_29 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_24;
@group(0) @binding(5)
var<storage> global_2: type_15;
@group(0) @binding(1)
var<storage> global_3: type_15;
@group(0) @binding(2)
var<storage> global_4: type_15;
@group(0) @binding(3)
var<storage> global_5: type_15;
@group(0) @binding(4)
var<storage> global_6: type_15;
@group(0) @binding(6)
var<storage> global_7: type_15;
@group(0) @binding(7)
var<storage, read_write> global_8: type_29;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var local_8: i32;
var local_9: i32;
var local_10: i32;
var local_11: i32;
var local_12: i32;
var local_13: i32;
var local_14: i32;
var local_15: i32;
var local_16: i32;
var local_17: i32;
var local_18: i32;
var local_19: i32;
var local_20: i32;
var local_21: i32;
var local_22: i32;
var local_23: i32;
var local_24: i32;
var local_25: i32;
var local_26: i32;
var local_27: i32;
var local_28: i32;
var local_29: i32;
var local_30: i32;
var local_31: i32;
var local_32: i32;
var local_33: i32;
var local_34: i32;
var local_35: i32;
var local_36: i32;
var local_37: i32;
var local_38: i32;
var local_39: i32;
var local_40: i32;
var local_41: i32;
var local_42: i32;
var local_43: i32;
var local_44: i32;
var local_45: i32;
var local_46: i32;
var local_47: i32;
var local_48: i32;
var local_49: i32;
var local_50: i32;
var local_51: i32;
var local_52: i32;
var local_53: i32;
var local_54: i32;
var local_55: i32;
var local_56: i32;
var local_57: i32;
var local_58: i32;
var local_59: i32;
var local_60: i32;
var local_61: i32;
var local_62: i32;
var local_63: i32;
var local_64: i32;
var local_65: i32;
var local_66: i32;
var local_67: i32;
var local_68: i32;
var local_69: i32;
var local_70: i32;
var local_71: i32;
var local_72: i32;
var local_73: i32;
var local_74: i32;
var local_75: i32;
var local_76: i32;
var local_77: i32;
var local_78: i32;
var local_79: i32;
var local_80: i32;
var local_81: i32;
var local_82: i32;
var local_83: i32;
var local_84: i32;
var local_85: i32;
var local_86: i32;
var local_87: i32;
var local_88: i32;
var local_89: i32;
var local_90: i32;
var local_91: i32;
var local_92: i32;
var local_93: i32;
var local_94: i32;
var local_95: i32;
var local_96: i32;
var local_97: i32;
var local_98: i32;
var local_99: i32;
var local_100: i32;
var local_101: i32;
var local_102: i32;
var local_103: i32;
var local_104: i32;
var local_105: i32;
var local_106: i32;
var local_107: i32;
var local_108: i32;
var local_109: i32;
var local_110: f32;
var local_111: i32;
var local_112: i32;
var local_113: i32;
var local_114: i32;
var local_115: i32;
var local_116: i32;
var local_117: i32;
var local_118: i32;
var local_119: i32;
var local_120: i32;
var local_121: i32;
var local_122: i32;
var local_123: i32;
var local_124: i32;
var local_125: i32;
var local_126: i32;
var local_127: i32;
var local_128: f32;
var local_129: i32;
var local_130: i32;
var local_131: i32;
var local_132: i32;
var local_133: i32;
var local_134: i32;
var local_135: i32;
var local_136: i32;
var local_137: i32;
var local_138: f32;
var local_139: i32;
var local_140: i32;
var local_141: i32;
var local_142: i32;
var local_143: i32;
var local_144: i32;
var local_145: i32;
var local_146: i32;
var local_147: i32;
var local_148: f32;
var local_149: i32;
var local_150: i32;
var local_151: i32;
var local_152: i32;
var local_153: i32;
var local_154: i32;
var local_155: i32;
var local_156: i32;
var local_157: i32;
var local_158: i32;
var local_159: i32;
var local_160: i32;
var local_161: i32;
var local_162: i32;
var local_163: i32;
var local_164: i32;
var local_165: i32;
var local_166: i32;
var local_167: i32;
var local_168: i32;
var local_169: i32;
var local_170: i32;
var local_171: i32;
var local_172: i32;
var local_173: i32;
var local_174: i32;
var local_175: i32;
var local_176: i32;
var local_177: i32;
var local_178: i32;
var local_179: i32;
var local_180: i32;
var local_181: i32;
var local_182: i32;
var local_183: i32;
var local_184: f32;
var local_185: i32;
var local_186: i32;
var local_187: i32;
var local_188: i32;
var local_189: i32;
var local_190: i32;
var local_191: i32;
var local_192: i32;
var local_193: i32;
var local_194: i32;
var local_195: i32;
var local_196: i32;
var local_197: i32;
var local_198: i32;
var local_199: i32;
var local_200: i32;
var local_201: i32;
var local_202: f32;
var local_203: i32;
var local_204: i32;
var local_205: i32;
var local_206: i32;
var local_207: i32;
var local_208: i32;
var local_209: i32;
var local_210: i32;
var local_211: i32;
var local_212: f32;
var local_213: i32;
var local_214: i32;
var local_215: i32;
var local_216: i32;
var local_217: i32;
var local_218: i32;
var local_219: i32;
var local_220: i32;
var local_221: i32;
var local_222: i32;
var local_223: i32;
var local_224: i32;
var local_225: i32;
var local_226: i32;
var local_227: i32;
var local_228: i32;
var local_229: i32;
var local_230: i32;
var local_231: i32;
var local_232: i32;
var local_233: i32;
var local_234: i32;
var local_235: i32;
var local_236: i32;
var local_237: i32;
var local_238: i32;
var local_239: i32;
var local_240: f32;
var local_241: i32;
var local_242: i32;
var local_243: i32;
var local_244: i32;
var local_245: i32;
var local_246: i32;
var local_247: i32;
var local_248: i32;
var local_249: i32;
var local_250: i32;
var local_251: i32;
var local_252: i32;
var local_253: i32;
var local_254: i32;
var local_255: i32;
var phi_883_: bool;
var phi_884_: bool;
var phi_885_: bool;
var phi_1265_: type_26;
var phi_1977_: f32;
var phi_1980_: u32;
var phi_1978_: f32;
var phi_1981_: u32;
var local_256: u32;
var phi_2010_: f32;
var phi_2013_: u32;
var phi_2011_: f32;
var phi_2014_: u32;
var phi_2025_: u32;
var phi_2080_: f32;
var phi_2083_: u32;
var phi_2081_: f32;
var phi_2084_: u32;
var local_257: u32;
var phi_2113_: f32;
var phi_2116_: u32;
var phi_2114_: f32;
var phi_2117_: u32;
var phi_2128_: u32;
var phi_2129_: u32;
var phi_2180_: f32;
var phi_2183_: u32;
var phi_2181_: f32;
var phi_2184_: u32;
var local_258: u32;
var phi_2213_: f32;
var phi_2216_: u32;
var phi_2214_: f32;
var phi_2217_: u32;
var phi_2228_: u32;
var phi_2229_: u32;
var phi_55020_: type_26;
var phi_55095_: i32;
var phi_77636_: type_26;
var phi_77711_: i32;
var phi_77715_: type_26;
var phi_77718_: i32;
var phi_77869_: type_26;
var phi_77872_: i32;
var phi_78002_: type_26;
var phi_78051_: u32;
var phi_78052_: u32;
var phi_78053_: u32;
var phi_78179_: i32;
var phi_78190_: i32;
var phi_78613_: f32;
var phi_79236_: type_26;
var phi_79433_: u32;
var phi_79434_: u32;
var phi_79435_: u32;
var phi_79469_: u32;
var phi_79499_: u32;
var phi_79529_: u32;
var phi_79566_: type_26;
var phi_77870_: type_26;
var phi_77873_: i32;
var phi_77716_: type_26;
var phi_77719_: i32;
var local_259: type_26;
var local_260: type_26;
var phi_79583_: i32;
var phi_87283_: i32;
var phi_87437_: i32;
var phi_87542_: type_26;
var phi_87969_: f32;
var phi_88595_: type_26;
var phi_88673_: i32;
var phi_88684_: i32;
var phi_88712_: type_26;
var phi_88761_: u32;
var phi_88762_: u32;
var phi_88763_: u32;
var phi_89747_: i32;
var phi_89758_: i32;
var phi_89786_: type_26;
var phi_89835_: u32;
var phi_89836_: u32;
var phi_89837_: u32;
var phi_90821_: i32;
var phi_90832_: i32;
var phi_90860_: type_26;
var phi_90909_: u32;
var phi_90910_: u32;
var phi_90911_: u32;
var phi_91895_: i32;
var phi_91906_: i32;
var phi_91934_: type_26;
var phi_91983_: u32;
var phi_91984_: u32;
var phi_91985_: u32;
var phi_92987_: type_26;
var phi_93065_: i32;
var phi_93076_: i32;
var phi_93104_: type_26;
var phi_93153_: u32;
var phi_93154_: u32;
var phi_93155_: u32;
var phi_94139_: i32;
var phi_94150_: i32;
var phi_94178_: type_26;
var phi_94227_: u32;
var phi_94228_: u32;
var phi_94229_: u32;
var phi_95213_: i32;
var phi_95224_: i32;
var phi_95252_: type_26;
var phi_95301_: u32;
var phi_95302_: u32;
var phi_95303_: u32;
var phi_96287_: i32;
var phi_96298_: i32;
var phi_96326_: type_26;
var phi_96375_: u32;
var phi_96376_: u32;
var phi_96377_: u32;
var phi_97379_: type_26;
var phi_97457_: i32;
var phi_97468_: i32;
var phi_97496_: type_26;
var phi_97545_: u32;
var phi_97546_: u32;
var phi_97547_: u32;
var phi_98531_: i32;
var phi_98542_: i32;
var phi_98570_: type_26;
var phi_98619_: u32;
var phi_98620_: u32;
var phi_98621_: u32;
var phi_99605_: i32;
var phi_99616_: i32;
var phi_99644_: type_26;
var phi_99693_: u32;
var phi_99694_: u32;
var phi_99695_: u32;
var phi_100679_: i32;
var phi_100690_: i32;
var phi_100718_: type_26;
var phi_100767_: u32;
var phi_100768_: u32;
var phi_100769_: u32;
var phi_101762_: type_26;
var phi_101995_: u32;
var phi_102025_: u32;
var phi_102055_: u32;
var phi_87438_: i32;
var phi_87284_: i32;
var phi_81248_: i32;
var phi_81402_: i32;
var phi_81507_: type_26;
var phi_81934_: f32;
var phi_82562_: type_26;
var phi_82640_: i32;
var phi_82651_: i32;
var phi_82679_: type_26;
var phi_82728_: u32;
var phi_82729_: u32;
var phi_82730_: u32;
var phi_83714_: i32;
var phi_83725_: i32;
var phi_83753_: type_26;
var phi_83802_: u32;
var phi_83803_: u32;
var phi_83804_: u32;
var phi_84788_: i32;
var phi_84799_: i32;
var phi_84827_: type_26;
var phi_84876_: u32;
var phi_84877_: u32;
var phi_84878_: u32;
var phi_85862_: i32;
var phi_85873_: i32;
var phi_85901_: type_26;
var phi_85950_: u32;
var phi_85951_: u32;
var phi_85952_: u32;
var phi_86945_: type_26;
var phi_87178_: u32;
var phi_87208_: u32;
var phi_87238_: u32;
var phi_81403_: i32;
var phi_81249_: i32;
var phi_79618_: i32;
var phi_79772_: i32;
var phi_79877_: type_26;
var phi_80304_: f32;
var phi_80906_: type_26;
var phi_81139_: u32;
var phi_81169_: u32;
var phi_81199_: u32;
var phi_79773_: i32;
var phi_79619_: i32;
var phi_62798_: i32;
var phi_62952_: i32;
var phi_63057_: type_26;
var phi_63484_: f32;
var phi_64110_: type_26;
var phi_64188_: i32;
var phi_64199_: i32;
var phi_64227_: type_26;
var phi_64276_: u32;
var phi_64277_: u32;
var phi_64278_: u32;
var phi_65262_: i32;
var phi_65273_: i32;
var phi_65301_: type_26;
var phi_65350_: u32;
var phi_65351_: u32;
var phi_65352_: u32;
var phi_66336_: i32;
var phi_66347_: i32;
var phi_66375_: type_26;
var phi_66424_: u32;
var phi_66425_: u32;
var phi_66426_: u32;
var phi_67410_: i32;
var phi_67421_: i32;
var phi_67449_: type_26;
var phi_67498_: u32;
var phi_67499_: u32;
var phi_67500_: u32;
var phi_68502_: type_26;
var phi_68580_: i32;
var phi_68591_: i32;
var phi_68619_: type_26;
var phi_68668_: u32;
var phi_68669_: u32;
var phi_68670_: u32;
var phi_69654_: i32;
var phi_69665_: i32;
var phi_69693_: type_26;
var phi_69742_: u32;
var phi_69743_: u32;
var phi_69744_: u32;
var phi_70728_: i32;
var phi_70739_: i32;
var phi_70767_: type_26;
var phi_70816_: u32;
var phi_70817_: u32;
var phi_70818_: u32;
var phi_71802_: i32;
var phi_71813_: i32;
var phi_71841_: type_26;
var phi_71890_: u32;
var phi_71891_: u32;
var phi_71892_: u32;
var phi_72894_: type_26;
var phi_72972_: i32;
var phi_72983_: i32;
var phi_73011_: type_26;
var phi_73060_: u32;
var phi_73061_: u32;
var phi_73062_: u32;
var phi_74046_: i32;
var phi_74057_: i32;
var phi_74085_: type_26;
var phi_74134_: u32;
var phi_74135_: u32;
var phi_74136_: u32;
var phi_75120_: i32;
var phi_75131_: i32;
var phi_75159_: type_26;
var phi_75208_: u32;
var phi_75209_: u32;
var phi_75210_: u32;
var phi_76194_: i32;
var phi_76205_: i32;
var phi_76233_: type_26;
var phi_76282_: u32;
var phi_76283_: u32;
var phi_76284_: u32;
var phi_77277_: type_26;
var phi_77510_: u32;
var phi_77540_: u32;
var phi_77570_: u32;
var phi_62953_: i32;
var phi_62799_: i32;
var phi_56763_: i32;
var phi_56917_: i32;
var phi_57022_: type_26;
var phi_57449_: f32;
var phi_58077_: type_26;
var phi_58155_: i32;
var phi_58166_: i32;
var phi_58194_: type_26;
var phi_58243_: u32;
var phi_58244_: u32;
var phi_58245_: u32;
var phi_59229_: i32;
var phi_59240_: i32;
var phi_59268_: type_26;
var phi_59317_: u32;
var phi_59318_: u32;
var phi_59319_: u32;
var phi_60303_: i32;
var phi_60314_: i32;
var phi_60342_: type_26;
var phi_60391_: u32;
var phi_60392_: u32;
var phi_60393_: u32;
var phi_61377_: i32;
var phi_61388_: i32;
var phi_61416_: type_26;
var phi_61465_: u32;
var phi_61466_: u32;
var phi_61467_: u32;
var phi_62460_: type_26;
var phi_62693_: u32;
var phi_62723_: u32;
var phi_62753_: u32;
var phi_56918_: i32;
var phi_56764_: i32;
var phi_55133_: i32;
var phi_55287_: i32;
var phi_55392_: type_26;
var phi_55819_: f32;
var phi_56421_: type_26;
var phi_56654_: u32;
var phi_56684_: u32;
var phi_56714_: u32;
var phi_55288_: i32;
var phi_55134_: i32;
var phi_6154_: type_26;
var phi_6229_: i32;
var phi_29526_: type_26;
var phi_29601_: i32;
var phi_29605_: type_26;
var phi_29608_: i32;
var phi_29759_: type_26;
var phi_29762_: i32;
var phi_29892_: type_26;
var phi_29941_: u32;
var phi_29942_: u32;
var phi_29943_: u32;
var phi_30069_: i32;
var phi_30080_: i32;
var phi_30503_: f32;
var phi_30635_: i32;
var phi_30648_: i32;
var phi_30662_: i32;
var phi_30966_: f32;
var phi_31093_: f32;
var phi_31378_: type_26;
var phi_31575_: u32;
var phi_31576_: u32;
var phi_31577_: u32;
var phi_31611_: u32;
var phi_31641_: u32;
var phi_31671_: u32;
var phi_31708_: type_26;
var phi_29760_: type_26;
var phi_29763_: i32;
var phi_29606_: type_26;
var phi_29609_: i32;
var local_261: type_26;
var local_262: type_26;
var phi_31725_: i32;
var phi_39929_: i32;
var phi_40083_: i32;
var phi_40188_: type_26;
var phi_40615_: f32;
var phi_40747_: i32;
var phi_40760_: i32;
var phi_40774_: i32;
var phi_41078_: f32;
var phi_41205_: f32;
var phi_41493_: type_26;
var phi_41571_: i32;
var phi_41582_: i32;
var phi_41610_: type_26;
var phi_41659_: u32;
var phi_41660_: u32;
var phi_41661_: u32;
var phi_42645_: i32;
var phi_42656_: i32;
var phi_42684_: type_26;
var phi_42733_: u32;
var phi_42734_: u32;
var phi_42735_: u32;
var phi_43719_: i32;
var phi_43730_: i32;
var phi_43758_: type_26;
var phi_43807_: u32;
var phi_43808_: u32;
var phi_43809_: u32;
var phi_44793_: i32;
var phi_44804_: i32;
var phi_44832_: type_26;
var phi_44881_: u32;
var phi_44882_: u32;
var phi_44883_: u32;
var phi_45885_: type_26;
var phi_45963_: i32;
var phi_45974_: i32;
var phi_46002_: type_26;
var phi_46051_: u32;
var phi_46052_: u32;
var phi_46053_: u32;
var phi_47037_: i32;
var phi_47048_: i32;
var phi_47076_: type_26;
var phi_47125_: u32;
var phi_47126_: u32;
var phi_47127_: u32;
var phi_48111_: i32;
var phi_48122_: i32;
var phi_48150_: type_26;
var phi_48199_: u32;
var phi_48200_: u32;
var phi_48201_: u32;
var phi_49185_: i32;
var phi_49196_: i32;
var phi_49224_: type_26;
var phi_49273_: u32;
var phi_49274_: u32;
var phi_49275_: u32;
var phi_50277_: type_26;
var phi_50355_: i32;
var phi_50366_: i32;
var phi_50394_: type_26;
var phi_50443_: u32;
var phi_50444_: u32;
var phi_50445_: u32;
var phi_51429_: i32;
var phi_51440_: i32;
var phi_51468_: type_26;
var phi_51517_: u32;
var phi_51518_: u32;
var phi_51519_: u32;
var phi_52503_: i32;
var phi_52514_: i32;
var phi_52542_: type_26;
var phi_52591_: u32;
var phi_52592_: u32;
var phi_52593_: u32;
var phi_53577_: i32;
var phi_53588_: i32;
var phi_53616_: type_26;
var phi_53665_: u32;
var phi_53666_: u32;
var phi_53667_: u32;
var phi_54660_: type_26;
var phi_54893_: u32;
var phi_54923_: u32;
var phi_54953_: u32;
var phi_40084_: i32;
var phi_39930_: i32;
var phi_33642_: i32;
var phi_33796_: i32;
var phi_33901_: type_26;
var phi_34328_: f32;
var phi_34460_: i32;
var phi_34473_: i32;
var phi_34487_: i32;
var phi_34791_: f32;
var phi_34918_: f32;
var phi_35208_: type_26;
var phi_35286_: i32;
var phi_35297_: i32;
var phi_35325_: type_26;
var phi_35374_: u32;
var phi_35375_: u32;
var phi_35376_: u32;
var phi_36360_: i32;
var phi_36371_: i32;
var phi_36399_: type_26;
var phi_36448_: u32;
var phi_36449_: u32;
var phi_36450_: u32;
var phi_37434_: i32;
var phi_37445_: i32;
var phi_37473_: type_26;
var phi_37522_: u32;
var phi_37523_: u32;
var phi_37524_: u32;
var phi_38508_: i32;
var phi_38519_: i32;
var phi_38547_: type_26;
var phi_38596_: u32;
var phi_38597_: u32;
var phi_38598_: u32;
var phi_39591_: type_26;
var phi_39824_: u32;
var phi_39854_: u32;
var phi_39884_: u32;
var phi_33797_: i32;
var phi_33643_: i32;
var phi_31760_: i32;
var phi_31914_: i32;
var phi_32019_: type_26;
var phi_32446_: f32;
var phi_32578_: i32;
var phi_32591_: i32;
var phi_32605_: i32;
var phi_32909_: f32;
var phi_33036_: f32;
var phi_33300_: type_26;
var phi_33533_: u32;
var phi_33563_: u32;
var phi_33593_: u32;
var phi_31915_: i32;
var phi_31761_: i32;
var phi_14436_: i32;
var phi_14590_: i32;
var phi_14695_: type_26;
var phi_15122_: f32;
var phi_15254_: i32;
var phi_15267_: i32;
var phi_15281_: i32;
var phi_15585_: f32;
var phi_15712_: f32;
var phi_16000_: type_26;
var phi_16078_: i32;
var phi_16089_: i32;
var phi_16117_: type_26;
var phi_16166_: u32;
var phi_16167_: u32;
var phi_16168_: u32;
var phi_17152_: i32;
var phi_17163_: i32;
var phi_17191_: type_26;
var phi_17240_: u32;
var phi_17241_: u32;
var phi_17242_: u32;
var phi_18226_: i32;
var phi_18237_: i32;
var phi_18265_: type_26;
var phi_18314_: u32;
var phi_18315_: u32;
var phi_18316_: u32;
var phi_19300_: i32;
var phi_19311_: i32;
var phi_19339_: type_26;
var phi_19388_: u32;
var phi_19389_: u32;
var phi_19390_: u32;
var phi_20392_: type_26;
var phi_20470_: i32;
var phi_20481_: i32;
var phi_20509_: type_26;
var phi_20558_: u32;
var phi_20559_: u32;
var phi_20560_: u32;
var phi_21544_: i32;
var phi_21555_: i32;
var phi_21583_: type_26;
var phi_21632_: u32;
var phi_21633_: u32;
var phi_21634_: u32;
var phi_22618_: i32;
var phi_22629_: i32;
var phi_22657_: type_26;
var phi_22706_: u32;
var phi_22707_: u32;
var phi_22708_: u32;
var phi_23692_: i32;
var phi_23703_: i32;
var phi_23731_: type_26;
var phi_23780_: u32;
var phi_23781_: u32;
var phi_23782_: u32;
var phi_24784_: type_26;
var phi_24862_: i32;
var phi_24873_: i32;
var phi_24901_: type_26;
var phi_24950_: u32;
var phi_24951_: u32;
var phi_24952_: u32;
var phi_25936_: i32;
var phi_25947_: i32;
var phi_25975_: type_26;
var phi_26024_: u32;
var phi_26025_: u32;
var phi_26026_: u32;
var phi_27010_: i32;
var phi_27021_: i32;
var phi_27049_: type_26;
var phi_27098_: u32;
var phi_27099_: u32;
var phi_27100_: u32;
var phi_28084_: i32;
var phi_28095_: i32;
var phi_28123_: type_26;
var phi_28172_: u32;
var phi_28173_: u32;
var phi_28174_: u32;
var phi_29167_: type_26;
var phi_29400_: u32;
var phi_29430_: u32;
var phi_29460_: u32;
var phi_14591_: i32;
var phi_14437_: i32;
var phi_8149_: i32;
var phi_8303_: i32;
var phi_8408_: type_26;
var phi_8835_: f32;
var phi_8967_: i32;
var phi_8980_: i32;
var phi_8994_: i32;
var phi_9298_: f32;
var phi_9425_: f32;
var phi_9715_: type_26;
var phi_9793_: i32;
var phi_9804_: i32;
var phi_9832_: type_26;
var phi_9881_: u32;
var phi_9882_: u32;
var phi_9883_: u32;
var phi_10867_: i32;
var phi_10878_: i32;
var phi_10906_: type_26;
var phi_10955_: u32;
var phi_10956_: u32;
var phi_10957_: u32;
var phi_11941_: i32;
var phi_11952_: i32;
var phi_11980_: type_26;
var phi_12029_: u32;
var phi_12030_: u32;
var phi_12031_: u32;
var phi_13015_: i32;
var phi_13026_: i32;
var phi_13054_: type_26;
var phi_13103_: u32;
var phi_13104_: u32;
var phi_13105_: u32;
var phi_14098_: type_26;
var phi_14331_: u32;
var phi_14361_: u32;
var phi_14391_: u32;
var phi_8304_: i32;
var phi_8150_: i32;
var phi_6267_: i32;
var phi_6421_: i32;
var phi_6526_: type_26;
var phi_6953_: f32;
var phi_7085_: i32;
var phi_7098_: i32;
var phi_7112_: i32;
var phi_7416_: f32;
var phi_7543_: f32;
var phi_7807_: type_26;
var phi_8040_: u32;
var phi_8070_: u32;
var phi_8100_: u32;
var phi_6422_: i32;
var phi_6268_: i32;
var phi_2274_: type_26;
var phi_2349_: i32;
var phi_2356_: i32;
var phi_2510_: i32;
var phi_2615_: type_26;
var phi_3048_: f32;
var phi_3180_: i32;
var phi_3193_: i32;
var phi_3207_: i32;
var phi_3408_: f32;
var phi_3643_: f32;
var phi_3770_: f32;
var phi_3800_: type_25;
var phi_4219_: f32;
var phi_4346_: f32;
var phi_4376_: type_25;
var phi_4798_: f32;
var phi_4925_: f32;
var phi_4955_: type_25;
var phi_5374_: f32;
var phi_5501_: f32;
var phi_5531_: type_25;
var phi_5790_: type_26;
var phi_6023_: u32;
var phi_6053_: u32;
var phi_6083_: u32;
var phi_2511_: i32;
var phi_2357_: i32;
var local_263: u32;
var local_264: u32;
var local_265: u32;
var local_266: u32;
var local_267: u32;
var local_268: u32;
var local_269: type_26;
var local_270: type_26;
let _e283 = global;
let _e293 = arrayLength((&global_5.member));
let _e296 = arrayLength((&global_6.member));
let _e299 = arrayLength((&global_2.member));
let _e302 = arrayLength((&global_7.member));
let _e304 = arrayLength((&global_8.member));
let _e307 = global_1.member.member;
if (_e283.x < _e307.member) {
if (_e283.y < _e307.member_1) {
let _e315 = bitcast<i32>(_e283.x);
let _e319 = global_1.member.member.member;
let _e320 = bitcast<i32>(_e319);
let _e324 = global_1.member.member_12.member_4;
let _e328 = global_1.member.member_12.member_7;
let _e330 = bitcast<i32>((_e324 * _e328));
let _e332 = bitcast<i32>((_e283.y * 16u));
local_253 = _e330;
local_254 = _e315;
local_255 = _e320;
let _e333 = local_253;
let _e334 = local_255;
let _e337 = local_254;
let _e338 = ((_e333 + (11i * _e334)) + _e337);
let _e340 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e342 = select(_e340, _e338, (_e338 < _e340));
let _e347 = global_4.member[bitcast<u32>(select(0i, _e342, (_e342 > 0i)))];
let _e348 = f32(_e332);
if (_e347 < _e348) {
phi_884_ = bool();
phi_885_ = true;
} else {
let _e350 = local_253;
let _e351 = local_255;
let _e354 = local_254;
let _e355 = ((_e350 + (10i * _e351)) + _e354);
let _e357 = select(_e340, _e355, (_e355 < _e340));
let _e362 = global_4.member[bitcast<u32>(select(0i, _e357, (_e357 > 0i)))];
let _e365 = (_e362 > f32((_e332 + 15i)));
if _e365 {
phi_883_ = bool();
} else {
let _e366 = local_253;
let _e367 = local_255;
let _e370 = local_254;
let _e371 = ((_e366 + (11i * _e367)) + _e370);
let _e373 = select(_e340, _e371, (_e371 < _e340));
let _e378 = global_4.member[bitcast<u32>(select(0i, _e373, (_e373 > 0i)))];
phi_883_ = (_e362 <= _e378);
}
let _e381 = phi_883_;
phi_884_ = _e381;
phi_885_ = _e365;
}
let _e383 = phi_884_;
let _e385 = phi_885_;
if select(_e383, false, _e385) {
local_250 = _e330;
local_251 = _e315;
local_252 = _e320;
let _e387 = local_250;
let _e388 = local_252;
let _e391 = local_251;
let _e392 = ((_e387 + (10i * _e388)) + _e391);
let _e394 = select(_e340, _e392, (_e392 < _e340));
let _e399 = global_4.member[bitcast<u32>(select(0i, _e394, (_e394 > 0i)))];
let _e400 = local_250;
let _e401 = local_252;
let _e404 = local_251;
let _e405 = ((_e400 + (11i * _e401)) + _e404);
let _e407 = select(_e340, _e405, (_e405 < _e340));
let _e412 = global_4.member[bitcast<u32>(select(0i, _e407, (_e407 > 0i)))];
let _e413 = local_250;
let _e414 = local_252;
let _e417 = local_251;
let _e418 = ((_e413 + (12i * _e414)) + _e417);
let _e420 = select(_e340, _e418, (_e418 < _e340));
let _e425 = global_4.member[bitcast<u32>(select(0i, _e420, (_e420 > 0i)))];
let _e426 = local_250;
let _e427 = local_252;
let _e430 = local_251;
let _e431 = ((_e426 + (13i * _e427)) + _e430);
let _e433 = select(_e340, _e431, (_e431 < _e340));
let _e438 = global_4.member[bitcast<u32>(select(0i, _e433, (_e433 > 0i)))];
local_247 = _e330;
local_248 = _e315;
local_249 = _e320;
let _e439 = local_247;
let _e440 = local_249;
let _e442 = local_248;
let _e443 = ((_e439 + _e440) + _e442);
let _e445 = select(_e340, _e443, (_e443 < _e340));
let _e450 = global_4.member[bitcast<u32>(select(0i, _e445, (_e445 > 0i)))];
let _e451 = local_247;
let _e452 = local_249;
let _e455 = local_248;
let _e456 = ((_e451 + (2i * _e452)) + _e455);
let _e458 = select(_e340, _e456, (_e456 < _e340));
let _e463 = global_4.member[bitcast<u32>(select(0i, _e458, (_e458 > 0i)))];
let _e464 = local_247;
let _e465 = local_249;
let _e468 = local_248;
let _e469 = ((_e464 + (3i * _e465)) + _e468);
let _e471 = select(_e340, _e469, (_e469 < _e340));
let _e476 = global_4.member[bitcast<u32>(select(0i, _e471, (_e471 > 0i)))];
let _e477 = local_247;
let _e478 = local_248;
let _e479 = (_e477 + _e478);
let _e481 = select(_e340, _e479, (_e479 < _e340));
let _e486 = global_4.member[bitcast<u32>(select(0i, _e481, (_e481 > 0i)))];
let _e487 = (_e486 > 0f);
let _e488 = local_247;
let _e489 = local_249;
let _e492 = local_248;
let _e493 = ((_e488 + (4i * _e489)) + _e492);
let _e495 = select(_e340, _e493, (_e493 < _e340));
let _e500 = global_4.member[bitcast<u32>(select(0i, _e495, (_e495 > 0i)))];
let _e501 = local_247;
let _e502 = local_249;
let _e505 = local_248;
let _e506 = ((_e501 + (5i * _e502)) + _e505);
let _e508 = select(_e340, _e506, (_e506 < _e340));
let _e513 = global_4.member[bitcast<u32>(select(0i, _e508, (_e508 > 0i)))];
let _e514 = local_247;
let _e515 = local_249;
let _e518 = local_248;
let _e519 = ((_e514 + (6i * _e515)) + _e518);
let _e521 = select(_e340, _e519, (_e519 < _e340));
let _e526 = global_4.member[bitcast<u32>(select(0i, _e521, (_e521 > 0i)))];
let _e527 = local_247;
let _e528 = local_249;
let _e531 = local_248;
let _e532 = ((_e527 + (7i * _e528)) + _e531);
let _e534 = select(_e340, _e532, (_e532 < _e340));
let _e539 = global_4.member[bitcast<u32>(select(0i, _e534, (_e534 > 0i)))];
let _e540 = local_247;
let _e541 = local_249;
let _e544 = local_248;
let _e545 = ((_e540 + (8i * _e541)) + _e544);
let _e547 = select(_e340, _e545, (_e545 < _e340));
let _e552 = global_4.member[bitcast<u32>(select(0i, _e547, (_e547 > 0i)))];
let _e553 = local_247;
let _e554 = local_249;
let _e557 = local_248;
let _e558 = ((_e553 + (9i * _e554)) + _e557);
let _e560 = select(_e340, _e558, (_e558 < _e340));
let _e565 = global_4.member[bitcast<u32>(select(0i, _e560, (_e560 > 0i)))];
let _e568 = bitcast<f32>((bitcast<u32>(_e463) & 2147483647u));
let _e572 = global_1.member.member_1.member;
let _e576 = global_1.member.member_1.member_1;
let _e577 = bitcast<i32>(_e572);
let _e578 = bitcast<i32>(_e576);
if _e487 {
phi_1265_ = type_26(_e578, _e577);
} else {
phi_1265_ = type_26(_e577, _e578);
}
let _e582 = phi_1265_;
let _e587 = global_1.member.member_12.member_10;
if ((_e487 != (_e587 == 1u)) || (_e332 >= _e582.member)) {
} else {
let _e595 = global_1.member.member_12.member_6;
local_244 = bitcast<i32>((_e324 * _e595));
local_245 = _e315;
local_246 = _e320;
let _e598 = local_244;
let _e599 = local_245;
let _e600 = (_e598 + _e599);
let _e602 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e604 = select(_e602, _e600, (_e600 < _e602));
let _e609 = global_3.member[bitcast<u32>(select(0i, _e604, (_e604 > 0i)))];
let _e610 = local_244;
let _e611 = local_246;
let _e613 = local_245;
let _e614 = ((_e610 + _e611) + _e613);
let _e616 = select(_e602, _e614, (_e614 < _e602));
let _e621 = global_3.member[bitcast<u32>(select(0i, _e616, (_e616 > 0i)))];
let _e622 = local_244;
let _e623 = local_246;
let _e626 = local_245;
let _e627 = ((_e622 + (2i * _e623)) + _e626);
let _e629 = select(_e602, _e627, (_e627 < _e602));
let _e634 = global_3.member[bitcast<u32>(select(0i, _e629, (_e629 > 0i)))];
let _e635 = local_244;
let _e636 = local_246;
let _e639 = local_245;
let _e640 = ((_e635 + (3i * _e636)) + _e639);
let _e642 = select(_e602, _e640, (_e640 < _e602));
let _e647 = global_3.member[bitcast<u32>(select(0i, _e642, (_e642 > 0i)))];
let _e648 = local_244;
let _e649 = local_246;
let _e652 = local_245;
let _e653 = ((_e648 + (4i * _e649)) + _e652);
let _e655 = select(_e602, _e653, (_e653 < _e602));
let _e660 = global_3.member[bitcast<u32>(select(0i, _e655, (_e655 > 0i)))];
let _e661 = local_244;
let _e662 = local_246;
let _e665 = local_245;
let _e666 = ((_e661 + (5i * _e662)) + _e665);
let _e668 = select(_e602, _e666, (_e666 < _e602));
let _e673 = global_3.member[bitcast<u32>(select(0i, _e668, (_e668 > 0i)))];
let _e674 = local_244;
let _e675 = local_246;
let _e678 = local_245;
let _e679 = ((_e674 + (18i * _e675)) + _e678);
let _e681 = select(_e602, _e679, (_e679 < _e602));
let _e686 = global_3.member[bitcast<u32>(select(0i, _e681, (_e681 > 0i)))];
let _e687 = local_244;
let _e688 = local_246;
let _e691 = local_245;
let _e692 = ((_e687 + (19i * _e688)) + _e691);
let _e694 = select(_e602, _e692, (_e692 < _e602));
let _e699 = global_3.member[bitcast<u32>(select(0i, _e694, (_e694 > 0i)))];
let _e700 = local_244;
let _e701 = local_246;
let _e704 = local_245;
let _e705 = ((_e700 + (20i * _e701)) + _e704);
let _e707 = select(_e602, _e705, (_e705 < _e602));
let _e712 = global_3.member[bitcast<u32>(select(0i, _e707, (_e707 > 0i)))];
let _e713 = local_244;
let _e714 = local_246;
let _e717 = local_245;
let _e718 = ((_e713 + (23i * _e714)) + _e717);
let _e720 = select(_e602, _e718, (_e718 < _e602));
let _e725 = global_3.member[bitcast<u32>(select(0i, _e720, (_e720 > 0i)))];
let _e726 = (_e332 + 16i);
let _e728 = (0.5f * (16f - 1f));
let _e729 = (_e348 + _e728);
let _e733 = (-(((_e450 * _e729) + _e476)) / _e463);
let _e751 = (0.5f * 1f);
let _e753 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e500 * _e729) + ((_e513 * _e733) + _e526))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e539 * _e729) + ((_e552 * _e733) + _e565))) & 2147483647u)))) / _e568) + _e751));
let _e757 = global_1.member.member_18.member_1;
phi_1977_ = 8f;
phi_1980_ = 0u;
loop {
let _e759 = phi_1977_;
let _e761 = phi_1980_;
local_256 = _e761;
local_263 = _e761;
let _e764 = ((_e761 < _e757) && (_e753 >= _e759));
if _e764 {
phi_1978_ = (_e759 * 2f);
phi_1981_ = (_e761 + 1u);
} else {
phi_1978_ = f32();
phi_1981_ = u32();
}
let _e768 = phi_1978_;
let _e770 = phi_1981_;
continue;
continuing {
phi_1977_ = _e768;
phi_1980_ = _e770;
break if !(_e764);
}
}
let _e773 = local_256;
let _e777 = f32((1i << bitcast<u32>((_e773 & 31u))));
let _e780 = f32(_e726);
if (((_e348 - _e777) > _e425) && ((_e780 + _e777) < _e438)) {
let _e28217 = local_263;
phi_2025_ = _e28217;
} else {
phi_2010_ = 8f;
phi_2013_ = 0u;
loop {
let _e786 = phi_2010_;
let _e788 = phi_2013_;
local_264 = _e788;
let _e791 = ((_e788 < _e757) && ((_e753 * 0.125f) >= _e786));
if _e791 {
phi_2011_ = (_e786 * 2f);
phi_2014_ = (_e788 + 1u);
} else {
phi_2011_ = f32();
phi_2014_ = u32();
}
let _e795 = phi_2011_;
let _e797 = phi_2014_;
continue;
continuing {
phi_2010_ = _e795;
phi_2013_ = _e797;
break if !(_e791);
}
}
let _e28219 = local_264;
phi_2025_ = _e28219;
}
let _e800 = phi_2025_;
let _e801 = (_e332 - 16i);
let _e803 = (_e399 <= _e412);
let _e804 = f32(_e801);
if ((_e801 >= 0i) && ((_e803 && (_e412 >= _e804)) && (_e399 <= f32((_e332 - 1i))))) {
let _e812 = (_e804 + _e728);
let _e816 = (-(((_e450 * _e812) + _e476)) / _e463);
let _e835 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e500 * _e812) + ((_e513 * _e816) + _e526))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e539 * _e812) + ((_e552 * _e816) + _e565))) & 2147483647u)))) / _e568) + _e751));
phi_2080_ = 8f;
phi_2083_ = 0u;
loop {
let _e837 = phi_2080_;
let _e839 = phi_2083_;
local_257 = _e839;
local_265 = _e839;
let _e842 = ((_e839 < _e757) && (_e835 >= _e837));
if _e842 {
phi_2081_ = (_e837 * 2f);
phi_2084_ = (_e839 + 1u);
} else {
phi_2081_ = f32();
phi_2084_ = u32();
}
let _e846 = phi_2081_;
let _e848 = phi_2084_;
continue;
continuing {
phi_2080_ = _e846;
phi_2083_ = _e848;
break if !(_e842);
}
}
let _e851 = local_257;
let _e855 = f32((1i << bitcast<u32>((_e851 & 31u))));
if (((_e804 - _e855) > _e425) && ((_e348 + _e855) < _e438)) {
let _e28231 = local_265;
phi_2128_ = _e28231;
} else {
phi_2113_ = 8f;
phi_2116_ = 0u;
loop {
let _e863 = phi_2113_;
let _e865 = phi_2116_;
local_266 = _e865;
let _e868 = ((_e865 < _e757) && ((_e835 * 0.125f) >= _e863));
if _e868 {
phi_2114_ = (_e863 * 2f);
phi_2117_ = (_e865 + 1u);
} else {
phi_2114_ = f32();
phi_2117_ = u32();
}
let _e872 = phi_2114_;
let _e874 = phi_2117_;
continue;
continuing {
phi_2113_ = _e872;
phi_2116_ = _e874;
break if !(_e868);
}
}
let _e28233 = local_266;
phi_2128_ = _e28233;
}
let _e877 = phi_2128_;
phi_2129_ = _e877;
} else {
phi_2129_ = _e800;
}
let _e879 = phi_2129_;
if ((_e726 < _e582.member) && ((_e803 && (_e412 >= _e780)) && (_e399 <= f32((_e332 + 31i))))) {
let _e889 = (_e780 + _e728);
let _e893 = (-(((_e450 * _e889) + _e476)) / _e463);
let _e912 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e500 * _e889) + ((_e513 * _e893) + _e526))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e539 * _e889) + ((_e552 * _e893) + _e565))) & 2147483647u)))) / _e568) + _e751));
phi_2180_ = 8f;
phi_2183_ = 0u;
loop {
let _e914 = phi_2180_;
let _e916 = phi_2183_;
local_258 = _e916;
local_267 = _e916;
let _e919 = ((_e916 < _e757) && (_e912 >= _e914));
if _e919 {
phi_2181_ = (_e914 * 2f);
phi_2184_ = (_e916 + 1u);
} else {
phi_2181_ = f32();
phi_2184_ = u32();
}
let _e923 = phi_2181_;
let _e925 = phi_2184_;
continue;
continuing {
phi_2180_ = _e923;
phi_2183_ = _e925;
break if !(_e919);
}
}
let _e928 = local_258;
let _e932 = f32((1i << bitcast<u32>((_e928 & 31u))));
if (((_e780 - _e932) > _e425) && ((f32((_e332 + 32i)) + _e932) < _e438)) {
let _e28246 = local_267;
phi_2228_ = _e28246;
} else {
phi_2213_ = 8f;
phi_2216_ = 0u;
loop {
let _e941 = phi_2213_;
let _e943 = phi_2216_;
local_268 = _e943;
let _e946 = ((_e943 < _e757) && ((_e912 * 0.125f) >= _e941));
if _e946 {
phi_2214_ = (_e941 * 2f);
phi_2217_ = (_e943 + 1u);
} else {
phi_2214_ = f32();
phi_2217_ = u32();
}
let _e950 = phi_2214_;
let _e952 = phi_2217_;
continue;
continuing {
phi_2213_ = _e950;
phi_2216_ = _e952;
break if !(_e946);
}
}
let _e28248 = local_268;
phi_2228_ = _e28248;
}
let _e955 = phi_2228_;
phi_2229_ = _e955;
} else {
phi_2229_ = _e800;
}
let _e957 = phi_2229_;
if (_e307.member_2 == 2u) {
let _e25773 = global_1.member.member_1.member;
let _e25776 = global_1.member.member_1.member_1;
let _e25777 = bitcast<i32>(_e25773);
let _e25778 = bitcast<i32>(_e25776);
if _e487 {
phi_2274_ = type_26(_e25778, _e25777);
} else {
phi_2274_ = type_26(_e25777, _e25778);
}
let _e25782 = phi_2274_;
let _e25786 = f32((_e332 + 15i));
let _e25788 = select(_e25786, _e412, (_e412 < _e25786));
let _e25790 = select(_e348, _e25788, (_e25788 > _e348));
let _e25792 = select(_e25786, _e25790, (_e25790 < _e25786));
let _e25799 = select(0i, select(select(i32(_e25792), i32(-2147483648), (_e25792 < -2147483600f)), 2147483647i, (_e25792 > 2147483500f)), (_e25792 == _e25792));
let _e25804 = bitcast<i32>((_e25799 - select(0i, 1i, (_e25792 < f32(_e25799)))));
let _e25806 = select(_e348, _e399, (_e399 > _e348));
let _e25808 = select(_e348, _e25806, (_e25806 > _e348));
let _e25810 = select(_e25786, _e25808, (_e25808 < _e25786));
let _e25817 = select(0i, select(select(i32(_e25810), i32(-2147483648), (_e25810 < -2147483600f)), 2147483647i, (_e25810 > 2147483500f)), (_e25810 == _e25810));
if (_e25804 < _e25782.member) {
phi_2349_ = _e25804;
} else {
phi_2349_ = (_e25782.member - 1i);
}
let _e25826 = phi_2349_;
phi_2356_ = 0i;
loop {
let _e25829 = phi_2356_;
let _e25830 = (_e25829 < 16i);
if _e25830 {
let _e25832 = (bitcast<i32>((_e25817 - select(0i, 1i, (_e25810 < f32(_e25817))))) + (_e25829 & 15i));
let _e25836 = (((f32(_e25832) + 0.5f) * 1f) - 0.5f);
let _e25840 = (-(((_e450 * _e25836) + _e476)) / _e463);
let _e25847 = bitcast<f32>((bitcast<u32>(((_e500 * _e25836) + ((_e513 * _e25840) + _e526))) & 2147483647u));
let _e25854 = bitcast<f32>((bitcast<u32>(((_e539 * _e25836) + ((_e552 * _e25840) + _e565))) & 2147483647u));
let _e25858 = (((0.5f * (_e25847 + _e25854)) / _e568) + _e751);
let _e25859 = (1f / 1f);
let _e25867 = ((((_e25840 + _e25858) + 0.5f) * _e25859) - 0.5f);
let _e25868 = f32((_e25782.member_1 - 1i));
let _e25869 = (0f - 1f);
let _e25871 = select(_e25869, _e25867, (_e25867 > _e25869));
let _e25873 = select(_e25868, _e25871, (_e25871 < _e25868));
let _e25880 = select(0i, select(select(i32(_e25873), i32(-2147483648), (_e25873 < -2147483600f)), 2147483647i, (_e25873 > 2147483500f)), (_e25873 == _e25873));
let _e25885 = (((((_e25840 - _e25858) + 0.5f) * _e25859) - 0.5f) + 1f);
let _e25886 = (_e25868 + 1f);
let _e25888 = select(0f, _e25885, (_e25885 > 0f));
let _e25890 = select(_e25886, _e25888, (_e25888 < _e25886));
let _e25897 = select(0i, select(select(i32(_e25890), i32(-2147483648), (_e25890 < -2147483600f)), 2147483647i, (_e25890 > 2147483500f)), (_e25890 == _e25890));
let _e25908 = ((1e-4f * 1f) * _e568);
let _e25910 = select(_e25854, _e25847, (_e25847 > _e25854));
let _e25912 = select(_e25908, _e25910, (_e25910 > _e25908));
let _e25914 = select(_e25854, _e25847, (_e25847 < _e25854));
let _e25916 = select(_e25908, _e25914, (_e25914 > _e25908));
let _e25918 = (0.5f * (_e25912 + _e25916));
let _e25919 = (0.5f / _e25916);
let _e25920 = (1f / _e25912);
phi_2510_ = 0i;
loop {
let _e25922 = phi_2510_;
let _e25924 = (((_e25897 - select(0i, 1i, (_e25890 < f32(_e25897)))) + (_e25829 >> bitcast<u32>(4u))) + bitcast<i32>(_e25922));
let _e25925 = (_e25924 <= select(-1i, (_e25880 - select(0i, 1i, (_e25873 < f32(_e25880)))), (_e25832 <= _e25826)));
if _e25925 {
let _e25931 = (((((f32(_e25924) + 0.5f) * 1f) - 0.5f) - _e25840) * _e568);
let _e25932 = (_e568 * 1f);
let _e25934 = (0.5f * _e25932);
let _e25935 = (_e25931 + _e25934);
let _e25936 = -(_e25935);
let _e25939 = (_e25918 - select(_e25936, _e25935, (_e25935 > _e25936)));
let _e25941 = select(0f, _e25939, (_e25939 > 0f));
let _e25943 = select(_e25916, _e25941, (_e25941 < _e25916));
let _e25946 = (_e25939 - _e25916);
let _e25950 = (((_e25943 * (_e25943 * _e25919)) + select(0f, _e25946, (_e25946 > 0f))) * _e25920);
let _e25954 = (_e25931 - _e25934);
let _e25955 = -(_e25954);
let _e25958 = (_e25918 - select(_e25955, _e25954, (_e25954 > _e25955)));
let _e25960 = select(0f, _e25958, (_e25958 > 0f));
let _e25962 = select(_e25916, _e25960, (_e25960 < _e25916));
let _e25965 = (_e25958 - _e25916);
let _e25969 = (((_e25962 * (_e25962 * _e25919)) + select(0f, _e25965, (_e25965 > 0f))) * _e25920);
if _e487 {
phi_2615_ = type_26(_e25924, _e25832);
} else {
phi_2615_ = type_26(_e25832, _e25924);
}
let _e25978 = phi_2615_;
let _e25982 = bitcast<i32>((_e25773 * _e25776));
local_242 = _e25982;
local_243 = ((_e25978.member_1 * _e25777) + _e25978.member);
let _e25985 = local_242;
let _e25986 = local_243;
let _e25987 = (_e25985 + _e25986);
let _e25989 = (bitcast<i32>(_e293) - 1i);
let _e25991 = select(_e25989, _e25987, (_e25987 < _e25989));
let _e25996 = global_5.member[bitcast<u32>(select(0i, _e25991, (_e25991 > 0i)))];
let _e25997 = local_242;
let _e25999 = local_243;
let _e26000 = ((2i * _e25997) + _e25999);
let _e26002 = select(_e25989, _e26000, (_e26000 < _e25989));
let _e26007 = global_5.member[bitcast<u32>(select(0i, _e26002, (_e26002 > 0i)))];
let _e26008 = local_243;
let _e26010 = select(_e25989, _e26008, (_e26008 < _e25989));
let _e26015 = global_5.member[bitcast<u32>(select(0i, _e26010, (_e26010 > 0i)))];
let _e26016 = local_243;
let _e26027 = global_1.member.member_2.member;
let _e26028 = (((((f32(_e25978.member) + 0.5f) / f32(_e25777)) * 2f) - 1f) * _e26027);
let _e26035 = global_1.member.member_2.member_1;
let _e26036 = ((1f - (((f32(_e25978.member_1) + 0.5f) / f32(_e25778)) * 2f)) * _e26035);
let _e26038 = global_1.member.member_3;
let _e26046 = global_1.member.member_4;
let _e26053 = ((_e26038.member * _e26028) + (_e26046.member * _e26036));
let _e26054 = ((_e26038.member_1 * _e26028) + (_e26046.member_1 * _e26036));
let _e26055 = ((_e26038.member_2 * _e26028) + (_e26046.member_2 * _e26036));
let _e26058 = global_1.member.member_2.member_3;
let _e26059 = (_e26058 != 0u);
let _e26061 = global_1.member.member_5;
let _e26068 = select((_e26061.member + _e26053), _e26061.member, _e26059);
let _e26069 = select((_e26061.member_1 + _e26054), _e26061.member_1, _e26059);
let _e26070 = select((_e26061.member_2 + _e26055), _e26061.member_2, _e26059);
let _e26072 = global_1.member.member_6;
let _e26079 = select(_e26072.member, (_e26072.member + _e26053), _e26059);
let _e26080 = select(_e26072.member_1, (_e26072.member_1 + _e26054), _e26059);
let _e26081 = select(_e26072.member_2, (_e26072.member_2 + _e26055), _e26059);
let _e26086 = (((_e26068 * _e26068) + (_e26069 * _e26069)) + (_e26070 * _e26070));
let _e26090 = (1f / sqrt(select(0f, _e26086, (_e26086 > 0f))));
let _e26091 = (_e26068 * _e26090);
let _e26092 = (_e26069 * _e26090);
let _e26093 = (_e26070 * _e26090);
let _e26094 = (_e609 - _e26079);
let _e26095 = (_e621 - _e26080);
let _e26096 = (_e634 - _e26081);
let _e26101 = (((_e26094 * _e26091) + (_e26095 * _e26092)) + (_e26096 * _e26093));
let _e26106 = (((_e26094 * _e647) + (_e26095 * _e660)) + (_e26096 * _e673));
let _e26111 = (((_e26091 * _e647) + (_e26092 * _e660)) + (_e26093 * _e673));
let _e26114 = ((_e26092 * _e673) - (_e26093 * _e660));
let _e26117 = ((_e26093 * _e647) - (_e26091 * _e673));
let _e26120 = ((_e26091 * _e660) - (_e26092 * _e647));
let _e26125 = (((_e26114 * _e26114) + (_e26117 * _e26117)) + (_e26120 * _e26120));
let _e26128 = (1f / select(1e-9f, _e26125, (_e26125 > 1e-9f)));
let _e26131 = ((_e26101 - (_e26111 * _e26106)) * _e26128);
let _e26134 = (((_e26111 * _e26101) - _e26106) * _e26128);
let _e26142 = global_1.member.member_12.member_16;
let _e26144 = -(_e26111);
let _e26147 = global_1.member.member_13.member_2;
let _e26148 = (_e26147 * _e26147);
let _e26152 = ((1f + _e26148) - ((2f * _e26147) * _e26144));
let _e26154 = select(1e-9f, _e26152, (_e26152 > 1e-9f));
let _e26166 = global_1.member.member_13.member_3;
if (_e26166 == 2u) {
let _e26171 = (0.5f - (0.5f * _e26144));
let _e26173 = select(0f, _e26171, (_e26171 > 0f));
let _e26177 = (sqrt(select(0f, _e26173, (_e26173 > 0f))) * 255f);
let _e26178 = (255f - 1f);
let _e26180 = select(0f, _e26177, (_e26177 > 0f));
let _e26182 = select(_e26178, _e26180, (_e26180 < _e26178));
let _e26189 = select(0i, select(select(i32(_e26182), i32(-2147483648), (_e26182 < -2147483600f)), 2147483647i, (_e26182 > 2147483500f)), (_e26182 == _e26182));
let _e26193 = (_e26189 - select(0i, 1i, (_e26182 < f32(_e26189))));
let _e26196 = global_1.member.member_13.member_11;
let _e26197 = bitcast<i32>(_e26196);
let _e26198 = (_e26197 + _e26193);
let _e26200 = (bitcast<i32>(_e299) - 1i);
let _e26202 = select(_e26200, _e26198, (_e26198 < _e26200));
let _e26207 = global_2.member[bitcast<u32>(select(0i, _e26202, (_e26202 > 0i)))];
let _e26209 = (_e26197 + (_e26193 + 1i));
let _e26211 = select(_e26200, _e26209, (_e26209 < _e26200));
let _e26216 = global_2.member[bitcast<u32>(select(0i, _e26211, (_e26211 > 0i)))];
phi_3048_ = (_e26207 + ((_e26216 - _e26207) * (_e26177 - f32(_e26193))));
} else {
phi_3048_ = select(((1f - _e26148) / (_e26154 * sqrt(select(0f, _e26154, (_e26154 > 0f))))), (0.75f * (1f + (_e26144 * _e26144))), (_e26166 == 1u));
}
let _e26223 = phi_3048_;
let _e26226 = ((_e568 * _e26142) * (_e26223 * (0.25f / 3.1415927f)));
let _e26229 = global_1.member.member_13.member_6;
if (false || (true && (_e26229 > 0u))) {
let _e26241 = global_1.member.member_13.member_7;
let _e26242 = bitcast<i32>(_e26241);
let _e26245 = global_1.member.member_13.member_8;
let _e26246 = bitcast<i32>(_e26245);
let _e26249 = global_1.member.member_13.member_9;
let _e26250 = bitcast<i32>(_e26249);
let _e26253 = global_1.member.member_13.member_4;
let _e26259 = global_1.member.member_13.member_5;
let _e26263 = f32(_e26242);
let _e26268 = (((((_e26079 + (_e26091 * _e26131)) - _e26253.member) / (_e26259.member - _e26253.member)) * _e26263) - 0.5f);
let _e26269 = (_e26263 - 1f);
let _e26271 = select(0f, _e26268, (_e26268 > 0f));
let _e26273 = select(_e26269, _e26271, (_e26271 < _e26269));
let _e26274 = f32(_e26246);
let _e26279 = (((((_e26080 + (_e26092 * _e26131)) - _e26253.member_1) / (_e26259.member_1 - _e26253.member_1)) * _e26274) - 0.5f);
let _e26280 = (_e26274 - 1f);
let _e26282 = select(0f, _e26279, (_e26279 > 0f));
let _e26284 = select(_e26280, _e26282, (_e26282 < _e26280));
let _e26285 = f32(_e26250);
let _e26290 = (((((_e26081 + (_e26093 * _e26131)) - _e26253.member_2) / (_e26259.member_2 - _e26253.member_2)) * _e26285) - 0.5f);
let _e26291 = (_e26285 - 1f);
let _e26293 = select(0f, _e26290, (_e26290 > 0f));
let _e26295 = select(_e26291, _e26293, (_e26293 < _e26291));
let _e26297 = select(0f, _e26273, (_e26273 > 0f));
let _e26299 = select(1e6f, _e26297, (_e26297 < 1e6f));
let _e26306 = select(0i, select(select(i32(_e26299), i32(-2147483648), (_e26299 < -2147483600f)), 2147483647i, (_e26299 > 2147483500f)), (_e26299 == _e26299));
let _e26310 = (_e26306 - select(0i, 1i, (_e26299 < f32(_e26306))));
let _e26312 = select(0f, _e26284, (_e26284 > 0f));
let _e26314 = select(1e6f, _e26312, (_e26312 < 1e6f));
let _e26321 = select(0i, select(select(i32(_e26314), i32(-2147483648), (_e26314 < -2147483600f)), 2147483647i, (_e26314 > 2147483500f)), (_e26314 == _e26314));
let _e26325 = (_e26321 - select(0i, 1i, (_e26314 < f32(_e26321))));
let _e26327 = select(0f, _e26295, (_e26295 > 0f));
let _e26329 = select(1e6f, _e26327, (_e26327 < 1e6f));
let _e26336 = select(0i, select(select(i32(_e26329), i32(-2147483648), (_e26329 < -2147483600f)), 2147483647i, (_e26329 > 2147483500f)), (_e26329 == _e26329));
let _e26340 = (_e26336 - select(0i, 1i, (_e26329 < f32(_e26336))));
let _e26344 = (_e26284 - f32(_e26325));
let _e26346 = (_e26295 - f32(_e26340));
local_240 = (_e26273 - f32(_e26310));
let _e26347 = (_e26310 + 1i);
let _e26349 = select(_e26347, 0i, (_e26347 < 0i));
if (_e26349 >= _e26242) {
phi_3180_ = (_e26242 - 1i);
} else {
phi_3180_ = _e26349;
}
let _e26353 = phi_3180_;
local_241 = (_e26353 - _e26310);
let _e26355 = (_e26325 + 1i);
let _e26357 = select(_e26355, 0i, (_e26355 < 0i));
if (_e26357 >= _e26246) {
phi_3193_ = (_e26246 - 1i);
} else {
phi_3193_ = _e26357;
}
let _e26361 = phi_3193_;
let _e26363 = ((_e26361 - _e26325) * _e26242);
let _e26364 = (_e26340 + 1i);
let _e26366 = select(_e26364, 0i, (_e26364 < 0i));
if (_e26366 >= _e26250) {
phi_3207_ = (_e26250 - 1i);
} else {
phi_3207_ = _e26366;
}
let _e26370 = phi_3207_;
let _e26376 = global_1.member.member_13.member_10;
let _e26382 = ((bitcast<i32>(_e26376) + (((_e26340 * _e26246) + _e26325) * _e26242)) + _e26310);
let _e26384 = (bitcast<i32>(_e299) - 1i);
let _e26386 = select(_e26384, _e26382, (_e26382 < _e26384));
let _e26391 = global_2.member[bitcast<u32>(select(0i, _e26386, (_e26386 > 0i)))];
let _e26392 = local_240;
let _e26395 = local_241;
let _e26396 = (_e26382 + _e26395);
let _e26398 = select(_e26384, _e26396, (_e26396 < _e26384));
let _e26403 = global_2.member[bitcast<u32>(select(0i, _e26398, (_e26398 > 0i)))];
let _e26404 = local_240;
let _e26407 = (1f - _e26344);
let _e26409 = (_e26382 + _e26363);
let _e26411 = select(_e26384, _e26409, (_e26409 < _e26384));
let _e26416 = global_2.member[bitcast<u32>(select(0i, _e26411, (_e26411 > 0i)))];
let _e26417 = local_240;
let _e26420 = local_241;
let _e26421 = (_e26409 + _e26420);
let _e26423 = select(_e26384, _e26421, (_e26421 < _e26384));
let _e26428 = global_2.member[bitcast<u32>(select(0i, _e26423, (_e26423 > 0i)))];
let _e26429 = local_240;
let _e26434 = (_e26382 + (((_e26370 - _e26340) * _e26242) * _e26246));
let _e26436 = select(_e26384, _e26434, (_e26434 < _e26384));
let _e26441 = global_2.member[bitcast<u32>(select(0i, _e26436, (_e26436 > 0i)))];
let _e26442 = local_240;
let _e26445 = local_241;
let _e26446 = (_e26434 + _e26445);
let _e26448 = select(_e26384, _e26446, (_e26446 < _e26384));
let _e26453 = global_2.member[bitcast<u32>(select(0i, _e26448, (_e26448 > 0i)))];
let _e26454 = local_240;
let _e26458 = (_e26434 + _e26363);
let _e26460 = select(_e26384, _e26458, (_e26458 < _e26384));
let _e26465 = global_2.member[bitcast<u32>(select(0i, _e26460, (_e26460 > 0i)))];
let _e26466 = local_240;
let _e26469 = local_241;
let _e26470 = (_e26458 + _e26469);
let _e26472 = select(_e26384, _e26470, (_e26470 < _e26384));
let _e26477 = global_2.member[bitcast<u32>(select(0i, _e26472, (_e26472 > 0i)))];
let _e26478 = local_240;
phi_3408_ = (_e26226 * ((((((_e26391 * (1f - _e26392)) + (_e26403 * _e26404)) * _e26407) + (((_e26416 * (1f - _e26417)) + (_e26428 * _e26429)) * _e26344)) * (1f - _e26346)) + (((((_e26441 * (1f - _e26442)) + (_e26453 * _e26454)) * _e26407) + (((_e26465 * (1f - _e26466)) + (_e26477 * _e26478)) * _e26344)) * _e26346)));
} else {
phi_3408_ = _e26226;
}
let _e26489 = phi_3408_;
let _e26492 = global_1.member.member_12.member_14;
let _e26493 = (_e26131 / _e26492);
let _e26495 = select(-1e9f, _e26493, (_e26493 > -1e9f));
let _e26497 = select(1e9f, _e26495, (_e26495 < 1e9f));
let _e26504 = select(0i, select(select(i32(_e26497), i32(-2147483648), (_e26497 < -2147483600f)), 2147483647i, (_e26497 > 2147483500f)), (_e26497 == _e26497));
let _e26508 = (_e26504 - select(0i, 1i, (_e26497 < f32(_e26504))));
let _e26511 = global_1.member.member_12.member_15;
let _e26513 = (f32(_e26508) * _e26492);
let _e26515 = ((_e26513 - _e26131) / _e26511);
let _e26520 = (-0.5f * 1.953f);
let _e26522 = (_e26520 * (_e26515 * _e26515));
let _e26524 = select(-87f, _e26522, (_e26522 > -87f));
let _e26526 = select(88f, _e26524, (_e26524 < 88f));
let _e26528 = ((_e26526 * 1.442695f) + 0.5f);
let _e26530 = select(-127f, _e26528, (_e26528 > -127f));
let _e26532 = select(128f, _e26530, (_e26530 < 128f));
let _e26539 = select(0i, select(select(i32(_e26532), i32(-2147483648), (_e26532 < -2147483600f)), 2147483647i, (_e26532 > 2147483500f)), (_e26532 == _e26532));
let _e26543 = (_e26539 - select(0i, 1i, (_e26532 < f32(_e26539))));
let _e26544 = f32(_e26543);
let _e26548 = ((_e26526 - (_e26544 * 0.6933594f)) - (_e26544 * -2.1219444e-4f));
let _e26574 = (_e26492 / _e26511);
let _e26576 = (_e26229 == 0u);
if _e26576 {
let _e26718 = (_e26513 - _e25996);
phi_3800_ = type_25(_e26134, select(0f, _e26718, (_e26718 > 0f)));
} else {
let _e26579 = global_1.member.member_12.member_12;
let _e26582 = global_1.member.member_12.member_4;
let _e26585 = global_1.member.member_12.member_13;
let _e26591 = global_1.member.member.member;
let _e26593 = (_e26134 / _e725);
local_237 = bitcast<i32>((_e26579 + (_e26582 * _e26585)));
local_238 = _e315;
local_239 = bitcast<i32>(_e26591);
let _e26594 = f32(_e26229);
let _e26596 = select(0f, _e26593, (_e26593 > 0f));
let _e26599 = (select(1f, _e26596, (_e26596 < 1f)) * _e26594);
let _e26600 = (_e26594 - 1f);
let _e26602 = select(0f, _e26600, (_e26600 > 0f));
let _e26604 = select(0f, _e26599, (_e26599 > 0f));
let _e26606 = select(_e26602, _e26604, (_e26604 < _e26602));
let _e26613 = select(0i, select(select(i32(_e26606), i32(-2147483648), (_e26606 < -2147483600f)), 2147483647i, (_e26606 > 2147483500f)), (_e26606 == _e26606));
let _e26617 = (_e26613 - select(0i, 1i, (_e26606 < f32(_e26613))));
if (_e26617 > 0i) {
let _e26620 = local_237;
let _e26621 = local_239;
let _e26624 = local_238;
let _e26625 = ((_e26620 + ((_e26617 - 1i) * _e26621)) + _e26624);
let _e26627 = (bitcast<i32>(_e302) - 1i);
let _e26629 = select(_e26627, _e26625, (_e26625 < _e26627));
let _e26634 = global_7.member[bitcast<u32>(select(0i, _e26629, (_e26629 > 0i)))];
phi_3643_ = _e26634;
} else {
phi_3643_ = 0f;
}
let _e26636 = phi_3643_;
let _e26637 = local_237;
let _e26638 = local_239;
let _e26641 = local_238;
let _e26642 = ((_e26637 + (_e26617 * _e26638)) + _e26641);
let _e26644 = (bitcast<i32>(_e302) - 1i);
let _e26646 = select(_e26644, _e26642, (_e26642 < _e26644));
let _e26651 = global_7.member[bitcast<u32>(select(0i, _e26646, (_e26646 > 0i)))];
let _e26658 = (_e26007 - _e25996);
let _e26661 = ((_e26513 - _e25996) / select(1e-9f, _e26658, (_e26658 > 1e-9f)));
local_234 = 0i;
local_235 = _e26016;
local_236 = _e25982;
let _e26663 = select(0f, _e26661, (_e26661 > 0f));
let _e26666 = (select(1f, _e26663, (_e26663 < 1f)) * _e26594);
let _e26668 = select(0f, _e26666, (_e26666 > 0f));
let _e26670 = select(_e26602, _e26668, (_e26668 < _e26602));
let _e26677 = select(0i, select(select(i32(_e26670), i32(-2147483648), (_e26670 < -2147483600f)), 2147483647i, (_e26670 > 2147483500f)), (_e26670 == _e26670));
let _e26681 = (_e26677 - select(0i, 1i, (_e26670 < f32(_e26677))));
if (_e26681 > 0i) {
let _e26684 = local_234;
let _e26685 = local_236;
let _e26688 = local_235;
let _e26689 = ((_e26684 + ((_e26681 - 1i) * _e26685)) + _e26688);
let _e26691 = select(_e26644, _e26689, (_e26689 < _e26644));
let _e26696 = global_7.member[bitcast<u32>(select(0i, _e26691, (_e26691 > 0i)))];
phi_3770_ = _e26696;
} else {
phi_3770_ = 0f;
}
let _e26698 = phi_3770_;
let _e26699 = local_234;
let _e26700 = local_236;
let _e26703 = local_235;
let _e26704 = ((_e26699 + (_e26681 * _e26700)) + _e26703);
let _e26706 = select(_e26644, _e26704, (_e26704 < _e26644));
let _e26711 = global_7.member[bitcast<u32>(select(0i, _e26706, (_e26706 > 0i)))];
phi_3800_ = type_25((_e26636 + ((_e26651 - _e26636) * (_e26599 - f32(_e26617)))), (_e26698 + ((_e26711 - _e26698) * (_e26666 - f32(_e26681)))));
}
let _e26723 = phi_3800_;
let _e26728 = select(_e26015, _e26007, (_e26007 < _e26015));
let _e26731 = (_e26723.member + _e26723.member_1);
let _e26734 = global_1.member.member_13.member;
let _e26739 = -((_e26734.member * _e26731));
let _e26741 = select(-87f, _e26739, (_e26739 > -87f));
let _e26743 = select(88f, _e26741, (_e26741 < 88f));
let _e26745 = ((_e26743 * 1.442695f) + 0.5f);
let _e26747 = select(-127f, _e26745, (_e26745 > -127f));
let _e26749 = select(128f, _e26747, (_e26747 < 128f));
let _e26756 = select(0i, select(select(i32(_e26749), i32(-2147483648), (_e26749 < -2147483600f)), 2147483647i, (_e26749 > 2147483500f)), (_e26749 == _e26749));
let _e26760 = (_e26756 - select(0i, 1i, (_e26749 < f32(_e26756))));
let _e26761 = f32(_e26760);
let _e26765 = ((_e26743 - (_e26761 * 0.6933594f)) - (_e26761 * -2.1219444e-4f));
let _e26787 = -((_e26734.member_1 * _e26731));
let _e26789 = select(-87f, _e26787, (_e26787 > -87f));
let _e26791 = select(88f, _e26789, (_e26789 < 88f));
let _e26793 = ((_e26791 * 1.442695f) + 0.5f);
let _e26795 = select(-127f, _e26793, (_e26793 > -127f));
let _e26797 = select(128f, _e26795, (_e26795 < 128f));
let _e26804 = select(0i, select(select(i32(_e26797), i32(-2147483648), (_e26797 < -2147483600f)), 2147483647i, (_e26797 > 2147483500f)), (_e26797 == _e26797));
let _e26808 = (_e26804 - select(0i, 1i, (_e26797 < f32(_e26804))));
let _e26809 = f32(_e26808);
let _e26813 = ((_e26791 - (_e26809 * 0.6933594f)) - (_e26809 * -2.1219444e-4f));
let _e26835 = -((_e26734.member_2 * _e26731));
let _e26837 = select(-87f, _e26835, (_e26835 > -87f));
let _e26839 = select(88f, _e26837, (_e26837 < 88f));
let _e26841 = ((_e26839 * 1.442695f) + 0.5f);
let _e26843 = select(-127f, _e26841, (_e26841 > -127f));
let _e26845 = select(128f, _e26843, (_e26843 < 128f));
let _e26852 = select(0i, select(select(i32(_e26845), i32(-2147483648), (_e26845 < -2147483600f)), 2147483647i, (_e26845 > 2147483500f)), (_e26845 == _e26845));
let _e26856 = (_e26852 - select(0i, 1i, (_e26845 < f32(_e26852))));
let _e26857 = f32(_e26856);
let _e26861 = ((_e26839 - (_e26857 * 0.6933594f)) - (_e26857 * -2.1219444e-4f));
let _e26882 = select(0f, (select(0f, (0.70403045f * (1f - ((1f - ((1f + (_e26548 * (1f + (_e26548 * (0.5f + (_e26548 * (0.16666667f + (_e26548 * (0.041666668f + (_e26548 * (0.008333334f + (_e26548 * (0.001388889f + (_e26548 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e26543 + 127i)) << bitcast<u32>(23i))))) * 1.1652954f))), (bitcast<f32>((bitcast<u32>(_e26515) & 2147483647u)) <= 1f)) * _e26574), ((_e26513 >= _e25996) && (_e26513 <= _e26728)));
let _e26888 = (f32((_e26508 + 1i)) * _e26492);
let _e26890 = ((_e26888 - _e26131) / _e26511);
let _e26896 = (_e26520 * (_e26890 * _e26890));
let _e26898 = select(-87f, _e26896, (_e26896 > -87f));
let _e26900 = select(88f, _e26898, (_e26898 < 88f));
let _e26902 = ((_e26900 * 1.442695f) + 0.5f);
let _e26904 = select(-127f, _e26902, (_e26902 > -127f));
let _e26906 = select(128f, _e26904, (_e26904 < 128f));
let _e26913 = select(0i, select(select(i32(_e26906), i32(-2147483648), (_e26906 < -2147483600f)), 2147483647i, (_e26906 > 2147483500f)), (_e26906 == _e26906));
let _e26917 = (_e26913 - select(0i, 1i, (_e26906 < f32(_e26913))));
let _e26918 = f32(_e26917);
let _e26922 = ((_e26900 - (_e26918 * 0.6933594f)) - (_e26918 * -2.1219444e-4f));
if _e26576 {
let _e27090 = (_e26888 - _e25996);
phi_4376_ = type_25(_e26134, select(0f, _e27090, (_e27090 > 0f)));
} else {
let _e26951 = global_1.member.member_12.member_12;
let _e26954 = global_1.member.member_12.member_4;
let _e26957 = global_1.member.member_12.member_13;
let _e26963 = global_1.member.member.member;
let _e26965 = (_e26134 / _e725);
local_231 = bitcast<i32>((_e26951 + (_e26954 * _e26957)));
local_232 = _e315;
local_233 = bitcast<i32>(_e26963);
let _e26966 = f32(_e26229);
let _e26968 = select(0f, _e26965, (_e26965 > 0f));
let _e26971 = (select(1f, _e26968, (_e26968 < 1f)) * _e26966);
let _e26972 = (_e26966 - 1f);
let _e26974 = select(0f, _e26972, (_e26972 > 0f));
let _e26976 = select(0f, _e26971, (_e26971 > 0f));
let _e26978 = select(_e26974, _e26976, (_e26976 < _e26974));
let _e26985 = select(0i, select(select(i32(_e26978), i32(-2147483648), (_e26978 < -2147483600f)), 2147483647i, (_e26978 > 2147483500f)), (_e26978 == _e26978));
let _e26989 = (_e26985 - select(0i, 1i, (_e26978 < f32(_e26985))));
if (_e26989 > 0i) {
let _e26992 = local_231;
let _e26993 = local_233;
let _e26996 = local_232;
let _e26997 = ((_e26992 + ((_e26989 - 1i) * _e26993)) + _e26996);
let _e26999 = (bitcast<i32>(_e302) - 1i);
let _e27001 = select(_e26999, _e26997, (_e26997 < _e26999));
let _e27006 = global_7.member[bitcast<u32>(select(0i, _e27001, (_e27001 > 0i)))];
phi_4219_ = _e27006;
} else {
phi_4219_ = 0f;
}
let _e27008 = phi_4219_;
let _e27009 = local_231;
let _e27010 = local_233;
let _e27013 = local_232;
let _e27014 = ((_e27009 + (_e26989 * _e27010)) + _e27013);
let _e27016 = (bitcast<i32>(_e302) - 1i);
let _e27018 = select(_e27016, _e27014, (_e27014 < _e27016));
let _e27023 = global_7.member[bitcast<u32>(select(0i, _e27018, (_e27018 > 0i)))];
let _e27030 = (_e26007 - _e25996);
let _e27033 = ((_e26888 - _e25996) / select(1e-9f, _e27030, (_e27030 > 1e-9f)));
local_228 = 0i;
local_229 = _e26016;
local_230 = _e25982;
let _e27035 = select(0f, _e27033, (_e27033 > 0f));
let _e27038 = (select(1f, _e27035, (_e27035 < 1f)) * _e26966);
let _e27040 = select(0f, _e27038, (_e27038 > 0f));
let _e27042 = select(_e26974, _e27040, (_e27040 < _e26974));
let _e27049 = select(0i, select(select(i32(_e27042), i32(-2147483648), (_e27042 < -2147483600f)), 2147483647i, (_e27042 > 2147483500f)), (_e27042 == _e27042));
let _e27053 = (_e27049 - select(0i, 1i, (_e27042 < f32(_e27049))));
if (_e27053 > 0i) {
let _e27056 = local_228;
let _e27057 = local_230;
let _e27060 = local_229;
let _e27061 = ((_e27056 + ((_e27053 - 1i) * _e27057)) + _e27060);
let _e27063 = select(_e27016, _e27061, (_e27061 < _e27016));
let _e27068 = global_7.member[bitcast<u32>(select(0i, _e27063, (_e27063 > 0i)))];
phi_4346_ = _e27068;
} else {
phi_4346_ = 0f;
}
let _e27070 = phi_4346_;
let _e27071 = local_228;
let _e27072 = local_230;
let _e27075 = local_229;
let _e27076 = ((_e27071 + (_e27053 * _e27072)) + _e27075);
let _e27078 = select(_e27016, _e27076, (_e27076 < _e27016));
let _e27083 = global_7.member[bitcast<u32>(select(0i, _e27078, (_e27078 > 0i)))];
phi_4376_ = type_25((_e27008 + ((_e27023 - _e27008) * (_e26971 - f32(_e26989)))), (_e27070 + ((_e27083 - _e27070) * (_e27038 - f32(_e27053)))));
}
let _e27095 = phi_4376_;
let _e27101 = (_e27095.member + _e27095.member_1);
let _e27103 = -((_e26734.member * _e27101));
let _e27105 = select(-87f, _e27103, (_e27103 > -87f));
let _e27107 = select(88f, _e27105, (_e27105 < 88f));
let _e27109 = ((_e27107 * 1.442695f) + 0.5f);
let _e27111 = select(-127f, _e27109, (_e27109 > -127f));
let _e27113 = select(128f, _e27111, (_e27111 < 128f));
let _e27120 = select(0i, select(select(i32(_e27113), i32(-2147483648), (_e27113 < -2147483600f)), 2147483647i, (_e27113 > 2147483500f)), (_e27113 == _e27113));
let _e27124 = (_e27120 - select(0i, 1i, (_e27113 < f32(_e27120))));
let _e27125 = f32(_e27124);
let _e27129 = ((_e27107 - (_e27125 * 0.6933594f)) - (_e27125 * -2.1219444e-4f));
let _e27151 = -((_e26734.member_1 * _e27101));
let _e27153 = select(-87f, _e27151, (_e27151 > -87f));
let _e27155 = select(88f, _e27153, (_e27153 < 88f));
let _e27157 = ((_e27155 * 1.442695f) + 0.5f);
let _e27159 = select(-127f, _e27157, (_e27157 > -127f));
let _e27161 = select(128f, _e27159, (_e27159 < 128f));
let _e27168 = select(0i, select(select(i32(_e27161), i32(-2147483648), (_e27161 < -2147483600f)), 2147483647i, (_e27161 > 2147483500f)), (_e27161 == _e27161));
let _e27172 = (_e27168 - select(0i, 1i, (_e27161 < f32(_e27168))));
let _e27173 = f32(_e27172);
let _e27177 = ((_e27155 - (_e27173 * 0.6933594f)) - (_e27173 * -2.1219444e-4f));
let _e27199 = -((_e26734.member_2 * _e27101));
let _e27201 = select(-87f, _e27199, (_e27199 > -87f));
let _e27203 = select(88f, _e27201, (_e27201 < 88f));
let _e27205 = ((_e27203 * 1.442695f) + 0.5f);
let _e27207 = select(-127f, _e27205, (_e27205 > -127f));
let _e27209 = select(128f, _e27207, (_e27207 < 128f));
let _e27216 = select(0i, select(select(i32(_e27209), i32(-2147483648), (_e27209 < -2147483600f)), 2147483647i, (_e27209 > 2147483500f)), (_e27209 == _e27209));
let _e27220 = (_e27216 - select(0i, 1i, (_e27209 < f32(_e27216))));
let _e27221 = f32(_e27220);
let _e27225 = ((_e27203 - (_e27221 * 0.6933594f)) - (_e27221 * -2.1219444e-4f));
let _e27246 = select(0f, (select(0f, (0.70403045f * (1f - ((1f - ((1f + (_e26922 * (1f + (_e26922 * (0.5f + (_e26922 * (0.16666667f + (_e26922 * (0.041666668f + (_e26922 * (0.008333334f + (_e26922 * (0.001388889f + (_e26922 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e26917 + 127i)) << bitcast<u32>(23i))))) * 1.1652954f))), (bitcast<f32>((bitcast<u32>(_e26890) & 2147483647u)) <= 1f)) * _e26574), ((_e26888 >= _e25996) && (_e26888 <= _e26728)));
let _e27255 = (f32((_e26508 - 1i)) * _e26492);
let _e27257 = ((_e27255 - _e26131) / _e26511);
let _e27263 = (_e26520 * (_e27257 * _e27257));
let _e27265 = select(-87f, _e27263, (_e27263 > -87f));
let _e27267 = select(88f, _e27265, (_e27265 < 88f));
let _e27269 = ((_e27267 * 1.442695f) + 0.5f);
let _e27271 = select(-127f, _e27269, (_e27269 > -127f));
let _e27273 = select(128f, _e27271, (_e27271 < 128f));
let _e27280 = select(0i, select(select(i32(_e27273), i32(-2147483648), (_e27273 < -2147483600f)), 2147483647i, (_e27273 > 2147483500f)), (_e27273 == _e27273));
let _e27284 = (_e27280 - select(0i, 1i, (_e27273 < f32(_e27280))));
let _e27285 = f32(_e27284);
let _e27289 = ((_e27267 - (_e27285 * 0.6933594f)) - (_e27285 * -2.1219444e-4f));
if _e26576 {
let _e27457 = (_e27255 - _e25996);
phi_4955_ = type_25(_e26134, select(0f, _e27457, (_e27457 > 0f)));
} else {
let _e27318 = global_1.member.member_12.member_12;
let _e27321 = global_1.member.member_12.member_4;
let _e27324 = global_1.member.member_12.member_13;
let _e27330 = global_1.member.member.member;
let _e27332 = (_e26134 / _e725);
local_225 = bitcast<i32>((_e27318 + (_e27321 * _e27324)));
local_226 = _e315;
local_227 = bitcast<i32>(_e27330);
let _e27333 = f32(_e26229);
let _e27335 = select(0f, _e27332, (_e27332 > 0f));
let _e27338 = (select(1f, _e27335, (_e27335 < 1f)) * _e27333);
let _e27339 = (_e27333 - 1f);
let _e27341 = select(0f, _e27339, (_e27339 > 0f));
let _e27343 = select(0f, _e27338, (_e27338 > 0f));
let _e27345 = select(_e27341, _e27343, (_e27343 < _e27341));
let _e27352 = select(0i, select(select(i32(_e27345), i32(-2147483648), (_e27345 < -2147483600f)), 2147483647i, (_e27345 > 2147483500f)), (_e27345 == _e27345));
let _e27356 = (_e27352 - select(0i, 1i, (_e27345 < f32(_e27352))));
if (_e27356 > 0i) {
let _e27359 = local_225;
let _e27360 = local_227;
let _e27363 = local_226;
let _e27364 = ((_e27359 + ((_e27356 - 1i) * _e27360)) + _e27363);
let _e27366 = (bitcast<i32>(_e302) - 1i);
let _e27368 = select(_e27366, _e27364, (_e27364 < _e27366));
let _e27373 = global_7.member[bitcast<u32>(select(0i, _e27368, (_e27368 > 0i)))];
phi_4798_ = _e27373;
} else {
phi_4798_ = 0f;
}
let _e27375 = phi_4798_;
let _e27376 = local_225;
let _e27377 = local_227;
let _e27380 = local_226;
let _e27381 = ((_e27376 + (_e27356 * _e27377)) + _e27380);
let _e27383 = (bitcast<i32>(_e302) - 1i);
let _e27385 = select(_e27383, _e27381, (_e27381 < _e27383));
let _e27390 = global_7.member[bitcast<u32>(select(0i, _e27385, (_e27385 > 0i)))];
let _e27397 = (_e26007 - _e25996);
let _e27400 = ((_e27255 - _e25996) / select(1e-9f, _e27397, (_e27397 > 1e-9f)));
local_222 = 0i;
local_223 = _e26016;
local_224 = _e25982;
let _e27402 = select(0f, _e27400, (_e27400 > 0f));
let _e27405 = (select(1f, _e27402, (_e27402 < 1f)) * _e27333);
let _e27407 = select(0f, _e27405, (_e27405 > 0f));
let _e27409 = select(_e27341, _e27407, (_e27407 < _e27341));
let _e27416 = select(0i, select(select(i32(_e27409), i32(-2147483648), (_e27409 < -2147483600f)), 2147483647i, (_e27409 > 2147483500f)), (_e27409 == _e27409));
let _e27420 = (_e27416 - select(0i, 1i, (_e27409 < f32(_e27416))));
if (_e27420 > 0i) {
let _e27423 = local_222;
let _e27424 = local_224;
let _e27427 = local_223;
let _e27428 = ((_e27423 + ((_e27420 - 1i) * _e27424)) + _e27427);
let _e27430 = select(_e27383, _e27428, (_e27428 < _e27383));
let _e27435 = global_7.member[bitcast<u32>(select(0i, _e27430, (_e27430 > 0i)))];
phi_4925_ = _e27435;
} else {
phi_4925_ = 0f;
}
let _e27437 = phi_4925_;
let _e27438 = local_222;
let _e27439 = local_224;
let _e27442 = local_223;
let _e27443 = ((_e27438 + (_e27420 * _e27439)) + _e27442);
let _e27445 = select(_e27383, _e27443, (_e27443 < _e27383));
let _e27450 = global_7.member[bitcast<u32>(select(0i, _e27445, (_e27445 > 0i)))];
phi_4955_ = type_25((_e27375 + ((_e27390 - _e27375) * (_e27338 - f32(_e27356)))), (_e27437 + ((_e27450 - _e27437) * (_e27405 - f32(_e27420)))));
}
let _e27462 = phi_4955_;
let _e27468 = (_e27462.member + _e27462.member_1);
let _e27470 = -((_e26734.member * _e27468));
let _e27472 = select(-87f, _e27470, (_e27470 > -87f));
let _e27474 = select(88f, _e27472, (_e27472 < 88f));
let _e27476 = ((_e27474 * 1.442695f) + 0.5f);
let _e27478 = select(-127f, _e27476, (_e27476 > -127f));
let _e27480 = select(128f, _e27478, (_e27478 < 128f));
let _e27487 = select(0i, select(select(i32(_e27480), i32(-2147483648), (_e27480 < -2147483600f)), 2147483647i, (_e27480 > 2147483500f)), (_e27480 == _e27480));
let _e27491 = (_e27487 - select(0i, 1i, (_e27480 < f32(_e27487))));
let _e27492 = f32(_e27491);
let _e27496 = ((_e27474 - (_e27492 * 0.6933594f)) - (_e27492 * -2.1219444e-4f));
let _e27518 = -((_e26734.member_1 * _e27468));
let _e27520 = select(-87f, _e27518, (_e27518 > -87f));
let _e27522 = select(88f, _e27520, (_e27520 < 88f));
let _e27524 = ((_e27522 * 1.442695f) + 0.5f);
let _e27526 = select(-127f, _e27524, (_e27524 > -127f));
let _e27528 = select(128f, _e27526, (_e27526 < 128f));
let _e27535 = select(0i, select(select(i32(_e27528), i32(-2147483648), (_e27528 < -2147483600f)), 2147483647i, (_e27528 > 2147483500f)), (_e27528 == _e27528));
let _e27539 = (_e27535 - select(0i, 1i, (_e27528 < f32(_e27535))));
let _e27540 = f32(_e27539);
let _e27544 = ((_e27522 - (_e27540 * 0.6933594f)) - (_e27540 * -2.1219444e-4f));
let _e27566 = -((_e26734.member_2 * _e27468));
let _e27568 = select(-87f, _e27566, (_e27566 > -87f));
let _e27570 = select(88f, _e27568, (_e27568 < 88f));
let _e27572 = ((_e27570 * 1.442695f) + 0.5f);
let _e27574 = select(-127f, _e27572, (_e27572 > -127f));
let _e27576 = select(128f, _e27574, (_e27574 < 128f));
let _e27583 = select(0i, select(select(i32(_e27576), i32(-2147483648), (_e27576 < -2147483600f)), 2147483647i, (_e27576 > 2147483500f)), (_e27576 == _e27576));
let _e27587 = (_e27583 - select(0i, 1i, (_e27576 < f32(_e27583))));
let _e27588 = f32(_e27587);
let _e27592 = ((_e27570 - (_e27588 * 0.6933594f)) - (_e27588 * -2.1219444e-4f));
let _e27613 = select(0f, (select(0f, (0.70403045f * (1f - ((1f - ((1f + (_e27289 * (1f + (_e27289 * (0.5f + (_e27289 * (0.16666667f + (_e27289 * (0.041666668f + (_e27289 * (0.008333334f + (_e27289 * (0.001388889f + (_e27289 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e27284 + 127i)) << bitcast<u32>(23i))))) * 1.1652954f))), (bitcast<f32>((bitcast<u32>(_e27257) & 2147483647u)) <= 1f)) * _e26574), ((_e27255 >= _e25996) && (_e27255 <= _e26728)));
let _e27619 = (f32((_e26508 + 2i)) * _e26492);
let _e27621 = ((_e27619 - _e26131) / _e26511);
let _e27627 = (_e26520 * (_e27621 * _e27621));
let _e27629 = select(-87f, _e27627, (_e27627 > -87f));
let _e27631 = select(88f, _e27629, (_e27629 < 88f));
let _e27633 = ((_e27631 * 1.442695f) + 0.5f);
let _e27635 = select(-127f, _e27633, (_e27633 > -127f));
let _e27637 = select(128f, _e27635, (_e27635 < 128f));
let _e27644 = select(0i, select(select(i32(_e27637), i32(-2147483648), (_e27637 < -2147483600f)), 2147483647i, (_e27637 > 2147483500f)), (_e27637 == _e27637));
let _e27648 = (_e27644 - select(0i, 1i, (_e27637 < f32(_e27644))));
let _e27649 = f32(_e27648);
let _e27653 = ((_e27631 - (_e27649 * 0.6933594f)) - (_e27649 * -2.1219444e-4f));
if _e26576 {
let _e27821 = (_e27619 - _e25996);
phi_5531_ = type_25(_e26134, select(0f, _e27821, (_e27821 > 0f)));
} else {
let _e27682 = global_1.member.member_12.member_12;
let _e27685 = global_1.member.member_12.member_4;
let _e27688 = global_1.member.member_12.member_13;
let _e27694 = global_1.member.member.member;
let _e27696 = (_e26134 / _e725);
local_219 = bitcast<i32>((_e27682 + (_e27685 * _e27688)));
local_220 = _e315;
local_221 = bitcast<i32>(_e27694);
let _e27697 = f32(_e26229);
let _e27699 = select(0f, _e27696, (_e27696 > 0f));
let _e27702 = (select(1f, _e27699, (_e27699 < 1f)) * _e27697);
let _e27703 = (_e27697 - 1f);
let _e27705 = select(0f, _e27703, (_e27703 > 0f));
let _e27707 = select(0f, _e27702, (_e27702 > 0f));
let _e27709 = select(_e27705, _e27707, (_e27707 < _e27705));
let _e27716 = select(0i, select(select(i32(_e27709), i32(-2147483648), (_e27709 < -2147483600f)), 2147483647i, (_e27709 > 2147483500f)), (_e27709 == _e27709));
let _e27720 = (_e27716 - select(0i, 1i, (_e27709 < f32(_e27716))));
if (_e27720 > 0i) {
let _e27723 = local_219;
let _e27724 = local_221;
let _e27727 = local_220;
let _e27728 = ((_e27723 + ((_e27720 - 1i) * _e27724)) + _e27727);
let _e27730 = (bitcast<i32>(_e302) - 1i);
let _e27732 = select(_e27730, _e27728, (_e27728 < _e27730));
let _e27737 = global_7.member[bitcast<u32>(select(0i, _e27732, (_e27732 > 0i)))];
phi_5374_ = _e27737;
} else {
phi_5374_ = 0f;
}
let _e27739 = phi_5374_;
let _e27740 = local_219;
let _e27741 = local_221;
let _e27744 = local_220;
let _e27745 = ((_e27740 + (_e27720 * _e27741)) + _e27744);
let _e27747 = (bitcast<i32>(_e302) - 1i);
let _e27749 = select(_e27747, _e27745, (_e27745 < _e27747));
let _e27754 = global_7.member[bitcast<u32>(select(0i, _e27749, (_e27749 > 0i)))];
let _e27761 = (_e26007 - _e25996);
let _e27764 = ((_e27619 - _e25996) / select(1e-9f, _e27761, (_e27761 > 1e-9f)));
local_216 = 0i;
local_217 = _e26016;
local_218 = _e25982;
let _e27766 = select(0f, _e27764, (_e27764 > 0f));
let _e27769 = (select(1f, _e27766, (_e27766 < 1f)) * _e27697);
let _e27771 = select(0f, _e27769, (_e27769 > 0f));
let _e27773 = select(_e27705, _e27771, (_e27771 < _e27705));
let _e27780 = select(0i, select(select(i32(_e27773), i32(-2147483648), (_e27773 < -2147483600f)), 2147483647i, (_e27773 > 2147483500f)), (_e27773 == _e27773));
let _e27784 = (_e27780 - select(0i, 1i, (_e27773 < f32(_e27780))));
if (_e27784 > 0i) {
let _e27787 = local_216;
let _e27788 = local_218;
let _e27791 = local_217;
let _e27792 = ((_e27787 + ((_e27784 - 1i) * _e27788)) + _e27791);
let _e27794 = select(_e27747, _e27792, (_e27792 < _e27747));
let _e27799 = global_7.member[bitcast<u32>(select(0i, _e27794, (_e27794 > 0i)))];
phi_5501_ = _e27799;
} else {
phi_5501_ = 0f;
}
let _e27801 = phi_5501_;
let _e27802 = local_216;
let _e27803 = local_218;
let _e27806 = local_217;
let _e27807 = ((_e27802 + (_e27784 * _e27803)) + _e27806);
let _e27809 = select(_e27747, _e27807, (_e27807 < _e27747));
let _e27814 = global_7.member[bitcast<u32>(select(0i, _e27809, (_e27809 > 0i)))];
phi_5531_ = type_25((_e27739 + ((_e27754 - _e27739) * (_e27702 - f32(_e27720)))), (_e27801 + ((_e27814 - _e27801) * (_e27769 - f32(_e27784)))));
}
let _e27826 = phi_5531_;
let _e27832 = (_e27826.member + _e27826.member_1);
let _e27834 = -((_e26734.member * _e27832));
let _e27836 = select(-87f, _e27834, (_e27834 > -87f));
let _e27838 = select(88f, _e27836, (_e27836 < 88f));
let _e27840 = ((_e27838 * 1.442695f) + 0.5f);
let _e27842 = select(-127f, _e27840, (_e27840 > -127f));
let _e27844 = select(128f, _e27842, (_e27842 < 128f));
let _e27851 = select(0i, select(select(i32(_e27844), i32(-2147483648), (_e27844 < -2147483600f)), 2147483647i, (_e27844 > 2147483500f)), (_e27844 == _e27844));
let _e27855 = (_e27851 - select(0i, 1i, (_e27844 < f32(_e27851))));
let _e27856 = f32(_e27855);
let _e27860 = ((_e27838 - (_e27856 * 0.6933594f)) - (_e27856 * -2.1219444e-4f));
let _e27882 = -((_e26734.member_1 * _e27832));
let _e27884 = select(-87f, _e27882, (_e27882 > -87f));
let _e27886 = select(88f, _e27884, (_e27884 < 88f));
let _e27888 = ((_e27886 * 1.442695f) + 0.5f);
let _e27890 = select(-127f, _e27888, (_e27888 > -127f));
let _e27892 = select(128f, _e27890, (_e27890 < 128f));
let _e27899 = select(0i, select(select(i32(_e27892), i32(-2147483648), (_e27892 < -2147483600f)), 2147483647i, (_e27892 > 2147483500f)), (_e27892 == _e27892));
let _e27903 = (_e27899 - select(0i, 1i, (_e27892 < f32(_e27899))));
let _e27904 = f32(_e27903);
let _e27908 = ((_e27886 - (_e27904 * 0.6933594f)) - (_e27904 * -2.1219444e-4f));
let _e27930 = -((_e26734.member_2 * _e27832));
let _e27932 = select(-87f, _e27930, (_e27930 > -87f));
let _e27934 = select(88f, _e27932, (_e27932 < 88f));
let _e27936 = ((_e27934 * 1.442695f) + 0.5f);
let _e27938 = select(-127f, _e27936, (_e27936 > -127f));
let _e27940 = select(128f, _e27938, (_e27938 < 128f));
let _e27947 = select(0i, select(select(i32(_e27940), i32(-2147483648), (_e27940 < -2147483600f)), 2147483647i, (_e27940 > 2147483500f)), (_e27940 == _e27940));
let _e27951 = (_e27947 - select(0i, 1i, (_e27940 < f32(_e27947))));
let _e27952 = f32(_e27951);
let _e27956 = ((_e27934 - (_e27952 * 0.6933594f)) - (_e27952 * -2.1219444e-4f));
let _e27977 = select(0f, (select(0f, (0.70403045f * (1f - ((1f - ((1f + (_e27653 * (1f + (_e27653 * (0.5f + (_e27653 * (0.16666667f + (_e27653 * (0.041666668f + (_e27653 * (0.008333334f + (_e27653 * (0.001388889f + (_e27653 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e27648 + 127i)) << bitcast<u32>(23i))))) * 1.1652954f))), (bitcast<f32>((bitcast<u32>(_e27621) & 2147483647u)) <= 1f)) * _e26574), ((_e27619 >= _e25996) && (_e27619 <= _e26728)));
let _e27989 = global_1.member.member_13.member_1;
let _e28002 = select(0f, _e26131, (((_e26134 >= 0f) && (_e26134 < _e725)) && (_e26131 > 0f)));
if _e487 {
phi_5790_ = type_26(_e25924, _e25832);
} else {
phi_5790_ = type_26(_e25832, _e25924);
}
let _e28013 = phi_5790_;
let _e28016 = (_e25925 && (((_e28002 > 0f) && (_e28002 < _e26015)) && true));
let _e28019 = global_1.member.member_18.member;
let _e28020 = (((select(_e25950, (1f - _e25950), (_e25935 >= 0f)) - select(_e25969, (1f - _e25969), (_e25954 >= 0f))) * (1f / _e25932)) * _e28019);
let _e28024 = select(0f, (((((_e686 * _e27989.member) * (((((1f + (_e26765 * (1f + (_e26765 * (0.5f + (_e26765 * (0.16666667f + (_e26765 * (0.041666668f + (_e26765 * (0.008333334f + (_e26765 * (0.001388889f + (_e26765 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e26760 + 127i)) << bitcast<u32>(23i)))) * _e26882) + (((1f + (_e27129 * (1f + (_e27129 * (0.5f + (_e27129 * (0.16666667f + (_e27129 * (0.041666668f + (_e27129 * (0.008333334f + (_e27129 * (0.001388889f + (_e27129 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e27124 + 127i)) << bitcast<u32>(23i)))) * _e27246)) + ((((1f + (_e27496 * (1f + (_e27496 * (0.5f + (_e27496 * (0.16666667f + (_e27496 * (0.041666668f + (_e27496 * (0.008333334f + (_e27496 * (0.001388889f + (_e27496 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e27491 + 127i)) << bitcast<u32>(23i)))) * _e27613) + (((1f + (_e27860 * (1f + (_e27860 * (0.5f + (_e27860 * (0.16666667f + (_e27860 * (0.041666668f + (_e27860 * (0.008333334f + (_e27860 * (0.001388889f + (_e27860 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e27855 + 127i)) << bitcast<u32>(23i)))) * _e27977)))) * _e26489) * 1f) * _e28020), _e28016);
let _e28025 = select(0f, (((((_e699 * _e27989.member_1) * (((((1f + (_e26813 * (1f + (_e26813 * (0.5f + (_e26813 * (0.16666667f + (_e26813 * (0.041666668f + (_e26813 * (0.008333334f + (_e26813 * (0.001388889f + (_e26813 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e26808 + 127i)) << bitcast<u32>(23i)))) * _e26882) + (((1f + (_e27177 * (1f + (_e27177 * (0.5f + (_e27177 * (0.16666667f + (_e27177 * (0.041666668f + (_e27177 * (0.008333334f + (_e27177 * (0.001388889f + (_e27177 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e27172 + 127i)) << bitcast<u32>(23i)))) * _e27246)) + ((((1f + (_e27544 * (1f + (_e27544 * (0.5f + (_e27544 * (0.16666667f + (_e27544 * (0.041666668f + (_e27544 * (0.008333334f + (_e27544 * (0.001388889f + (_e27544 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e27539 + 127i)) << bitcast<u32>(23i)))) * _e27613) + (((1f + (_e27908 * (1f + (_e27908 * (0.5f + (_e27908 * (0.16666667f + (_e27908 * (0.041666668f + (_e27908 * (0.008333334f + (_e27908 * (0.001388889f + (_e27908 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e27903 + 127i)) << bitcast<u32>(23i)))) * _e27977)))) * _e26489) * 1f) * _e28020), _e28016);
let _e28026 = select(0f, (((((_e712 * _e27989.member_2) * (((((1f + (_e26861 * (1f + (_e26861 * (0.5f + (_e26861 * (0.16666667f + (_e26861 * (0.041666668f + (_e26861 * (0.008333334f + (_e26861 * (0.001388889f + (_e26861 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e26856 + 127i)) << bitcast<u32>(23i)))) * _e26882) + (((1f + (_e27225 * (1f + (_e27225 * (0.5f + (_e27225 * (0.16666667f + (_e27225 * (0.041666668f + (_e27225 * (0.008333334f + (_e27225 * (0.001388889f + (_e27225 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e27220 + 127i)) << bitcast<u32>(23i)))) * _e27246)) + ((((1f + (_e27592 * (1f + (_e27592 * (0.5f + (_e27592 * (0.16666667f + (_e27592 * (0.041666668f + (_e27592 * (0.008333334f + (_e27592 * (0.001388889f + (_e27592 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e27587 + 127i)) << bitcast<u32>(23i)))) * _e27613) + (((1f + (_e27956 * (1f + (_e27956 * (0.5f + (_e27956 * (0.16666667f + (_e27956 * (0.041666668f + (_e27956 * (0.008333334f + (_e27956 * (0.001388889f + (_e27956 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e27951 + 127i)) << bitcast<u32>(23i)))) * _e27977)))) * _e26489) * 1f) * _e28020), _e28016);
let _e28030 = (bitcast<f32>((bitcast<u32>(_e28024) & 2147483647u)) >= 1073741800f);
let _e28031 = (1f / 1048576f);
let _e28034 = ((_e28024 * select(1f, _e28031, _e28030)) + 0.5f);
let _e28036 = select(-1073741800f, _e28034, (_e28034 > -1073741800f));
let _e28038 = select(1073741800f, _e28036, (_e28036 < 1073741800f));
let _e28045 = select(0i, select(select(i32(_e28038), i32(-2147483648), (_e28038 < -2147483600f)), 2147483647i, (_e28038 > 2147483500f)), (_e28038 == _e28038));
let _e28049 = (_e28045 - select(0i, 1i, (_e28038 < f32(_e28045))));
let _e28050 = select(0i, 20i, _e28030);
let _e28054 = (bitcast<u32>(_e28049) << bitcast<u32>((_e28050 & 31i)));
let _e28061 = bitcast<u32>(((_e28049 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e28050) & 31i))));
let _e28065 = (bitcast<f32>((bitcast<u32>(_e28025) & 2147483647u)) >= 1073741800f);
let _e28068 = ((_e28025 * select(1f, _e28031, _e28065)) + 0.5f);
let _e28070 = select(-1073741800f, _e28068, (_e28068 > -1073741800f));
let _e28072 = select(1073741800f, _e28070, (_e28070 < 1073741800f));
let _e28079 = select(0i, select(select(i32(_e28072), i32(-2147483648), (_e28072 < -2147483600f)), 2147483647i, (_e28072 > 2147483500f)), (_e28072 == _e28072));
let _e28083 = (_e28079 - select(0i, 1i, (_e28072 < f32(_e28079))));
let _e28084 = select(0i, 20i, _e28065);
let _e28088 = (bitcast<u32>(_e28083) << bitcast<u32>((_e28084 & 31i)));
let _e28095 = bitcast<u32>(((_e28083 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e28084) & 31i))));
let _e28099 = (bitcast<f32>((bitcast<u32>(_e28026) & 2147483647u)) >= 1073741800f);
let _e28102 = ((_e28026 * select(1f, _e28031, _e28099)) + 0.5f);
let _e28104 = select(-1073741800f, _e28102, (_e28102 > -1073741800f));
let _e28106 = select(1073741800f, _e28104, (_e28104 < 1073741800f));
let _e28113 = select(0i, select(select(i32(_e28106), i32(-2147483648), (_e28106 < -2147483600f)), 2147483647i, (_e28106 > 2147483500f)), (_e28106 == _e28106));
let _e28117 = (_e28113 - select(0i, 1i, (_e28106 < f32(_e28113))));
let _e28118 = select(0i, 20i, _e28099);
let _e28122 = (bitcast<u32>(_e28117) << bitcast<u32>((_e28118 & 31i)));
let _e28129 = bitcast<u32>(((_e28117 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e28118) & 31i))));
let _e28134 = bitcast<i32>(bitcast<u32>((((_e28013.member_1 * _e25777) + _e28013.member) * 6i)));
if ((_e28054 | _e28061) == 0u) {
} else {
let _e28137 = bitcast<u32>(_e28134);
if (_e28137 < _e304) {
let _e28141 = atomicAdd((&global_8.member[_e28137]), _e28054);
phi_6023_ = _e28141;
} else {
phi_6023_ = 0u;
}
let _e28143 = phi_6023_;
let _e28147 = (_e28061 + select(0u, 1u, ((_e28143 + _e28054) < _e28054)));
if (_e28147 == 0u) {
} else {
let _e28149 = (_e28137 + 1u);
if (_e28149 < _e304) {
let _e28153 = atomicAdd((&global_8.member[_e28149]), _e28147);
}
}
}
if ((_e28088 | _e28095) == 0u) {
} else {
let _e28157 = bitcast<u32>((_e28134 + 2i));
if (_e28157 < _e304) {
let _e28161 = atomicAdd((&global_8.member[_e28157]), _e28088);
phi_6053_ = _e28161;
} else {
phi_6053_ = 0u;
}
let _e28163 = phi_6053_;
let _e28167 = (_e28095 + select(0u, 1u, ((_e28163 + _e28088) < _e28088)));
if (_e28167 == 0u) {
} else {
let _e28169 = (_e28157 + 1u);
if (_e28169 < _e304) {
let _e28173 = atomicAdd((&global_8.member[_e28169]), _e28167);
}
}
}
if ((_e28122 | _e28129) == 0u) {
} else {
let _e28177 = bitcast<u32>((_e28134 + 4i));
if (_e28177 < _e304) {
let _e28181 = atomicAdd((&global_8.member[_e28177]), _e28122);
phi_6083_ = _e28181;
} else {
phi_6083_ = 0u;
}
let _e28183 = phi_6083_;
let _e28187 = (_e28129 + select(0u, 1u, ((_e28183 + _e28122) < _e28122)));
if (_e28187 == 0u) {
} else {
let _e28189 = (_e28177 + 1u);
if (_e28189 < _e304) {
let _e28193 = atomicAdd((&global_8.member[_e28189]), _e28187);
}
}
}
phi_2511_ = (_e25922 + 1i);
} else {
phi_2511_ = i32();
}
let _e28196 = phi_2511_;
continue;
continuing {
phi_2510_ = _e28196;
break if !(_e25925);
}
}
phi_2357_ = (_e25829 + 1i);
} else {
phi_2357_ = i32();
}
let _e28200 = phi_2357_;
continue;
continuing {
phi_2356_ = _e28200;
break if !(_e25830);
}
}
} else {
if (_e307.member_2 == 1u) {
let _e11943 = global_1.member.member_1.member;
let _e11946 = global_1.member.member_1.member_1;
let _e11947 = bitcast<i32>(_e11943);
let _e11948 = bitcast<i32>(_e11946);
if _e487 {
phi_6154_ = type_26(_e11948, _e11947);
} else {
phi_6154_ = type_26(_e11947, _e11948);
}
let _e11952 = phi_6154_;
let _e11956 = f32((_e332 + 15i));
let _e11958 = select(_e11956, _e412, (_e412 < _e11956));
let _e11960 = select(_e348, _e11958, (_e11958 > _e348));
let _e11962 = select(_e11956, _e11960, (_e11960 < _e11956));
let _e11969 = select(0i, select(select(i32(_e11962), i32(-2147483648), (_e11962 < -2147483600f)), 2147483647i, (_e11962 > 2147483500f)), (_e11962 == _e11962));
let _e11973 = (_e11969 - select(0i, 1i, (_e11962 < f32(_e11969))));
let _e11974 = bitcast<i32>(_e11973);
let _e11976 = select(_e348, _e399, (_e399 > _e348));
let _e11978 = select(_e348, _e11976, (_e11976 > _e348));
let _e11980 = select(_e11956, _e11978, (_e11978 < _e11956));
let _e11987 = select(0i, select(select(i32(_e11980), i32(-2147483648), (_e11980 < -2147483600f)), 2147483647i, (_e11980 > 2147483500f)), (_e11980 == _e11980));
let _e11991 = (_e11987 - select(0i, 1i, (_e11980 < f32(_e11987))));
let _e11992 = bitcast<i32>(_e11991);
if (_e11974 < _e11952.member) {
phi_6229_ = _e11974;
} else {
phi_6229_ = (_e11952.member - 1i);
}
let _e11996 = phi_6229_;
let _e11997 = (_e11952.member_1 - 1i);
let _e11998 = (_e800 == 0u);
if _e11998 {
let _e19556 = select(_e879, 0u, (_e879 == _e800));
let _e19560 = select(_e957, 0u, ((_e957 == _e800) || (_e957 == _e879)));
let _e19568 = ((select(0u, 1u, (_e800 > 0u)) + select(0u, 1u, (_e19556 > 0u))) + select(0u, 1u, (_e19560 > 0u)));
if (_e19568 == 0u) {
phi_6267_ = 0i;
loop {
let _e24613 = phi_6267_;
let _e24614 = (_e24613 < 16i);
if _e24614 {
let _e24616 = (_e11992 + (_e24613 & 15i));
let _e24620 = (((f32(_e24616) + 0.5f) * 1f) - 0.5f);
let _e24624 = (-(((_e450 * _e24620) + _e476)) / _e463);
let _e24631 = bitcast<f32>((bitcast<u32>(((_e500 * _e24620) + ((_e513 * _e24624) + _e526))) & 2147483647u));
let _e24638 = bitcast<f32>((bitcast<u32>(((_e539 * _e24620) + ((_e552 * _e24624) + _e565))) & 2147483647u));
let _e24642 = (((0.5f * (_e24631 + _e24638)) / _e568) + _e751);
let _e24643 = (1f / 1f);
let _e24651 = ((((_e24624 + _e24642) + 0.5f) * _e24643) - 0.5f);
let _e24652 = f32(_e11997);
let _e24653 = (0f - 1f);
let _e24655 = select(_e24653, _e24651, (_e24651 > _e24653));
let _e24657 = select(_e24652, _e24655, (_e24655 < _e24652));
let _e24664 = select(0i, select(select(i32(_e24657), i32(-2147483648), (_e24657 < -2147483600f)), 2147483647i, (_e24657 > 2147483500f)), (_e24657 == _e24657));
let _e24669 = (((((_e24624 - _e24642) + 0.5f) * _e24643) - 0.5f) + 1f);
let _e24670 = (_e24652 + 1f);
let _e24672 = select(0f, _e24669, (_e24669 > 0f));
let _e24674 = select(_e24670, _e24672, (_e24672 < _e24670));
let _e24681 = select(0i, select(select(i32(_e24674), i32(-2147483648), (_e24674 < -2147483600f)), 2147483647i, (_e24674 > 2147483500f)), (_e24674 == _e24674));
let _e24692 = ((1e-4f * 1f) * _e568);
let _e24694 = select(_e24638, _e24631, (_e24631 > _e24638));
let _e24696 = select(_e24692, _e24694, (_e24694 > _e24692));
let _e24698 = select(_e24638, _e24631, (_e24631 < _e24638));
let _e24700 = select(_e24692, _e24698, (_e24698 > _e24692));
let _e24702 = (0.5f * (_e24696 + _e24700));
let _e24703 = (0.5f / _e24700);
let _e24704 = (1f / _e24696);
phi_6421_ = 0i;
loop {
let _e24706 = phi_6421_;
let _e24708 = (((_e24681 - select(0i, 1i, (_e24674 < f32(_e24681)))) + (_e24613 >> bitcast<u32>(4u))) + bitcast<i32>(_e24706));
let _e24709 = (_e24708 <= select(-1i, (_e24664 - select(0i, 1i, (_e24657 < f32(_e24664)))), (_e24616 <= _e11996)));
if _e24709 {
let _e24715 = (((((f32(_e24708) + 0.5f) * 1f) - 0.5f) - _e24624) * _e568);
let _e24716 = (_e568 * 1f);
let _e24718 = (0.5f * _e24716);
let _e24719 = (_e24715 + _e24718);
let _e24720 = -(_e24719);
let _e24723 = (_e24702 - select(_e24720, _e24719, (_e24719 > _e24720)));
let _e24725 = select(0f, _e24723, (_e24723 > 0f));
let _e24727 = select(_e24700, _e24725, (_e24725 < _e24700));
let _e24730 = (_e24723 - _e24700);
let _e24734 = (((_e24727 * (_e24727 * _e24703)) + select(0f, _e24730, (_e24730 > 0f))) * _e24704);
let _e24738 = (_e24715 - _e24718);
let _e24739 = -(_e24738);
let _e24742 = (_e24702 - select(_e24739, _e24738, (_e24738 > _e24739)));
let _e24744 = select(0f, _e24742, (_e24742 > 0f));
let _e24746 = select(_e24700, _e24744, (_e24744 < _e24700));
let _e24749 = (_e24742 - _e24700);
let _e24753 = (((_e24746 * (_e24746 * _e24703)) + select(0f, _e24749, (_e24749 > 0f))) * _e24704);
if _e487 {
phi_6526_ = type_26(_e24708, _e24616);
} else {
phi_6526_ = type_26(_e24616, _e24708);
}
let _e24762 = phi_6526_;
let _e24766 = bitcast<i32>((_e11943 * _e11946));
local_214 = _e24766;
local_215 = ((_e24762.member_1 * _e11947) + _e24762.member);
let _e24769 = local_214;
let _e24770 = local_215;
let _e24771 = (_e24769 + _e24770);
let _e24773 = (bitcast<i32>(_e293) - 1i);
let _e24775 = select(_e24773, _e24771, (_e24771 < _e24773));
let _e24780 = global_5.member[bitcast<u32>(select(0i, _e24775, (_e24775 > 0i)))];
let _e24781 = local_214;
let _e24783 = local_215;
let _e24784 = ((2i * _e24781) + _e24783);
let _e24786 = select(_e24773, _e24784, (_e24784 < _e24773));
let _e24791 = global_5.member[bitcast<u32>(select(0i, _e24786, (_e24786 > 0i)))];
let _e24792 = local_215;
let _e24794 = select(_e24773, _e24792, (_e24792 < _e24773));
let _e24799 = global_5.member[bitcast<u32>(select(0i, _e24794, (_e24794 > 0i)))];
let _e24800 = local_215;
let _e24811 = global_1.member.member_2.member;
let _e24812 = (((((f32(_e24762.member) + 0.5f) / f32(_e11947)) * 2f) - 1f) * _e24811);
let _e24819 = global_1.member.member_2.member_1;
let _e24820 = ((1f - (((f32(_e24762.member_1) + 0.5f) / f32(_e11948)) * 2f)) * _e24819);
let _e24822 = global_1.member.member_3;
let _e24830 = global_1.member.member_4;
let _e24837 = ((_e24822.member * _e24812) + (_e24830.member * _e24820));
let _e24838 = ((_e24822.member_1 * _e24812) + (_e24830.member_1 * _e24820));
let _e24839 = ((_e24822.member_2 * _e24812) + (_e24830.member_2 * _e24820));
let _e24842 = global_1.member.member_2.member_3;
let _e24843 = (_e24842 != 0u);
let _e24845 = global_1.member.member_5;
let _e24852 = select((_e24845.member + _e24837), _e24845.member, _e24843);
let _e24853 = select((_e24845.member_1 + _e24838), _e24845.member_1, _e24843);
let _e24854 = select((_e24845.member_2 + _e24839), _e24845.member_2, _e24843);
let _e24856 = global_1.member.member_6;
let _e24863 = select(_e24856.member, (_e24856.member + _e24837), _e24843);
let _e24864 = select(_e24856.member_1, (_e24856.member_1 + _e24838), _e24843);
let _e24865 = select(_e24856.member_2, (_e24856.member_2 + _e24839), _e24843);
let _e24870 = (((_e24852 * _e24852) + (_e24853 * _e24853)) + (_e24854 * _e24854));
let _e24873 = sqrt(select(0f, _e24870, (_e24870 > 0f)));
let _e24874 = (1f / _e24873);
let _e24875 = (_e24852 * _e24874);
let _e24876 = (_e24853 * _e24874);
let _e24877 = (_e24854 * _e24874);
let _e24878 = (_e609 - _e24863);
let _e24879 = (_e621 - _e24864);
let _e24880 = (_e634 - _e24865);
let _e24885 = (((_e24878 * _e24875) + (_e24879 * _e24876)) + (_e24880 * _e24877));
let _e24890 = (((_e24878 * _e647) + (_e24879 * _e660)) + (_e24880 * _e673));
let _e24895 = (((_e24875 * _e647) + (_e24876 * _e660)) + (_e24877 * _e673));
let _e24898 = ((_e24876 * _e673) - (_e24877 * _e660));
let _e24901 = ((_e24877 * _e647) - (_e24875 * _e673));
let _e24904 = ((_e24875 * _e660) - (_e24876 * _e647));
let _e24909 = (((_e24898 * _e24898) + (_e24901 * _e24901)) + (_e24904 * _e24904));
let _e24912 = (1f / select(1e-9f, _e24909, (_e24909 > 1e-9f)));
let _e24915 = ((_e24885 - (_e24895 * _e24890)) * _e24912);
let _e24918 = (((_e24895 * _e24885) - _e24890) * _e24912);
let _e24924 = -(_e24895);
let _e24927 = global_1.member.member_13.member_2;
let _e24928 = (_e24927 * _e24927);
let _e24932 = ((1f + _e24928) - ((2f * _e24927) * _e24924));
let _e24934 = select(1e-9f, _e24932, (_e24932 > 1e-9f));
let _e24946 = global_1.member.member_13.member_3;
if (_e24946 == 2u) {
let _e24951 = (0.5f - (0.5f * _e24924));
let _e24953 = select(0f, _e24951, (_e24951 > 0f));
let _e24957 = (sqrt(select(0f, _e24953, (_e24953 > 0f))) * 255f);
let _e24958 = (255f - 1f);
let _e24960 = select(0f, _e24957, (_e24957 > 0f));
let _e24962 = select(_e24958, _e24960, (_e24960 < _e24958));
let _e24969 = select(0i, select(select(i32(_e24962), i32(-2147483648), (_e24962 < -2147483600f)), 2147483647i, (_e24962 > 2147483500f)), (_e24962 == _e24962));
let _e24973 = (_e24969 - select(0i, 1i, (_e24962 < f32(_e24969))));
let _e24976 = global_1.member.member_13.member_11;
let _e24977 = bitcast<i32>(_e24976);
let _e24978 = (_e24977 + _e24973);
let _e24980 = (bitcast<i32>(_e299) - 1i);
let _e24982 = select(_e24980, _e24978, (_e24978 < _e24980));
let _e24987 = global_2.member[bitcast<u32>(select(0i, _e24982, (_e24982 > 0i)))];
let _e24989 = (_e24977 + (_e24973 + 1i));
let _e24991 = select(_e24980, _e24989, (_e24989 < _e24980));
let _e24996 = global_2.member[bitcast<u32>(select(0i, _e24991, (_e24991 > 0i)))];
phi_6953_ = (_e24987 + ((_e24996 - _e24987) * (_e24957 - f32(_e24973))));
} else {
phi_6953_ = select(((1f - _e24928) / (_e24934 * sqrt(select(0f, _e24934, (_e24934 > 0f))))), (0.75f * (1f + (_e24924 * _e24924))), (_e24946 == 1u));
}
let _e25003 = phi_6953_;
let _e25015 = global_1.member.member_13.member_7;
let _e25016 = bitcast<i32>(_e25015);
let _e25019 = global_1.member.member_13.member_8;
let _e25020 = bitcast<i32>(_e25019);
let _e25023 = global_1.member.member_13.member_9;
let _e25024 = bitcast<i32>(_e25023);
let _e25027 = global_1.member.member_13.member_4;
let _e25033 = global_1.member.member_13.member_5;
let _e25037 = f32(_e25016);
let _e25042 = (((((_e24863 + (_e24875 * _e24915)) - _e25027.member) / (_e25033.member - _e25027.member)) * _e25037) - 0.5f);
let _e25043 = (_e25037 - 1f);
let _e25045 = select(0f, _e25042, (_e25042 > 0f));
let _e25047 = select(_e25043, _e25045, (_e25045 < _e25043));
let _e25048 = f32(_e25020);
let _e25053 = (((((_e24864 + (_e24876 * _e24915)) - _e25027.member_1) / (_e25033.member_1 - _e25027.member_1)) * _e25048) - 0.5f);
let _e25054 = (_e25048 - 1f);
let _e25056 = select(0f, _e25053, (_e25053 > 0f));
let _e25058 = select(_e25054, _e25056, (_e25056 < _e25054));
let _e25059 = f32(_e25024);
let _e25064 = (((((_e24865 + (_e24877 * _e24915)) - _e25027.member_2) / (_e25033.member_2 - _e25027.member_2)) * _e25059) - 0.5f);
let _e25065 = (_e25059 - 1f);
let _e25067 = select(0f, _e25064, (_e25064 > 0f));
let _e25069 = select(_e25065, _e25067, (_e25067 < _e25065));
let _e25071 = select(0f, _e25047, (_e25047 > 0f));
let _e25073 = select(1e6f, _e25071, (_e25071 < 1e6f));
let _e25080 = select(0i, select(select(i32(_e25073), i32(-2147483648), (_e25073 < -2147483600f)), 2147483647i, (_e25073 > 2147483500f)), (_e25073 == _e25073));
let _e25084 = (_e25080 - select(0i, 1i, (_e25073 < f32(_e25080))));
let _e25086 = select(0f, _e25058, (_e25058 > 0f));
let _e25088 = select(1e6f, _e25086, (_e25086 < 1e6f));
let _e25095 = select(0i, select(select(i32(_e25088), i32(-2147483648), (_e25088 < -2147483600f)), 2147483647i, (_e25088 > 2147483500f)), (_e25088 == _e25088));
let _e25099 = (_e25095 - select(0i, 1i, (_e25088 < f32(_e25095))));
let _e25101 = select(0f, _e25069, (_e25069 > 0f));
let _e25103 = select(1e6f, _e25101, (_e25101 < 1e6f));
let _e25110 = select(0i, select(select(i32(_e25103), i32(-2147483648), (_e25103 < -2147483600f)), 2147483647i, (_e25103 > 2147483500f)), (_e25103 == _e25103));
let _e25114 = (_e25110 - select(0i, 1i, (_e25103 < f32(_e25110))));
let _e25118 = (_e25058 - f32(_e25099));
let _e25120 = (_e25069 - f32(_e25114));
local_212 = (_e25047 - f32(_e25084));
let _e25121 = (_e25084 + 1i);
let _e25123 = select(_e25121, 0i, (_e25121 < 0i));
if (_e25123 >= _e25016) {
phi_7085_ = (_e25016 - 1i);
} else {
phi_7085_ = _e25123;
}
let _e25127 = phi_7085_;
local_213 = (_e25127 - _e25084);
let _e25129 = (_e25099 + 1i);
let _e25131 = select(_e25129, 0i, (_e25129 < 0i));
if (_e25131 >= _e25020) {
phi_7098_ = (_e25020 - 1i);
} else {
phi_7098_ = _e25131;
}
let _e25135 = phi_7098_;
let _e25137 = ((_e25135 - _e25099) * _e25016);
let _e25138 = (_e25114 + 1i);
let _e25140 = select(_e25138, 0i, (_e25138 < 0i));
if (_e25140 >= _e25024) {
phi_7112_ = (_e25024 - 1i);
} else {
phi_7112_ = _e25140;
}
let _e25144 = phi_7112_;
let _e25150 = global_1.member.member_13.member_10;
let _e25156 = ((bitcast<i32>(_e25150) + (((_e25114 * _e25020) + _e25099) * _e25016)) + _e25084);
let _e25158 = (bitcast<i32>(_e299) - 1i);
let _e25160 = select(_e25158, _e25156, (_e25156 < _e25158));
let _e25165 = global_2.member[bitcast<u32>(select(0i, _e25160, (_e25160 > 0i)))];
let _e25166 = local_212;
let _e25169 = local_213;
let _e25170 = (_e25156 + _e25169);
let _e25172 = select(_e25158, _e25170, (_e25170 < _e25158));
let _e25177 = global_2.member[bitcast<u32>(select(0i, _e25172, (_e25172 > 0i)))];
let _e25178 = local_212;
let _e25181 = (1f - _e25118);
let _e25183 = (_e25156 + _e25137);
let _e25185 = select(_e25158, _e25183, (_e25183 < _e25158));
let _e25190 = global_2.member[bitcast<u32>(select(0i, _e25185, (_e25185 > 0i)))];
let _e25191 = local_212;
let _e25194 = local_213;
let _e25195 = (_e25183 + _e25194);
let _e25197 = select(_e25158, _e25195, (_e25195 < _e25158));
let _e25202 = global_2.member[bitcast<u32>(select(0i, _e25197, (_e25197 > 0i)))];
let _e25203 = local_212;
let _e25208 = (_e25156 + (((_e25144 - _e25114) * _e25016) * _e25020));
let _e25210 = select(_e25158, _e25208, (_e25208 < _e25158));
let _e25215 = global_2.member[bitcast<u32>(select(0i, _e25210, (_e25210 > 0i)))];
let _e25216 = local_212;
let _e25219 = local_213;
let _e25220 = (_e25208 + _e25219);
let _e25222 = select(_e25158, _e25220, (_e25220 < _e25158));
let _e25227 = global_2.member[bitcast<u32>(select(0i, _e25222, (_e25222 > 0i)))];
let _e25228 = local_212;
let _e25232 = (_e25208 + _e25137);
let _e25234 = select(_e25158, _e25232, (_e25232 < _e25158));
let _e25239 = global_2.member[bitcast<u32>(select(0i, _e25234, (_e25234 > 0i)))];
let _e25240 = local_212;
let _e25243 = local_213;
let _e25244 = (_e25232 + _e25243);
let _e25246 = select(_e25158, _e25244, (_e25244 < _e25158));
let _e25251 = global_2.member[bitcast<u32>(select(0i, _e25246, (_e25246 > 0i)))];
let _e25252 = local_212;
let _e25261 = ((_e24873 * (_e25003 * (0.25f / 3.1415927f))) * ((((((_e25165 * (1f - _e25166)) + (_e25177 * _e25178)) * _e25181) + (((_e25190 * (1f - _e25191)) + (_e25202 * _e25203)) * _e25118)) * (1f - _e25120)) + (((((_e25215 * (1f - _e25216)) + (_e25227 * _e25228)) * _e25181) + (((_e25239 * (1f - _e25240)) + (_e25251 * _e25252)) * _e25118)) * _e25120)));
let _e25264 = global_1.member.member_12.member_12;
let _e25267 = global_1.member.member_12.member_4;
let _e25270 = global_1.member.member_12.member_13;
let _e25276 = global_1.member.member.member;
let _e25278 = (_e24918 / _e725);
local_209 = bitcast<i32>((_e25264 + (_e25267 * _e25270)));
local_210 = _e315;
local_211 = bitcast<i32>(_e25276);
let _e25281 = global_1.member.member_13.member_6;
let _e25282 = f32(_e25281);
let _e25284 = select(0f, _e25278, (_e25278 > 0f));
let _e25287 = (select(1f, _e25284, (_e25284 < 1f)) * _e25282);
let _e25288 = (_e25282 - 1f);
let _e25290 = select(0f, _e25288, (_e25288 > 0f));
let _e25292 = select(0f, _e25287, (_e25287 > 0f));
let _e25294 = select(_e25290, _e25292, (_e25292 < _e25290));
let _e25301 = select(0i, select(select(i32(_e25294), i32(-2147483648), (_e25294 < -2147483600f)), 2147483647i, (_e25294 > 2147483500f)), (_e25294 == _e25294));
let _e25305 = (_e25301 - select(0i, 1i, (_e25294 < f32(_e25301))));
if (_e25305 > 0i) {
let _e25308 = local_209;
let _e25309 = local_211;
let _e25312 = local_210;
let _e25313 = ((_e25308 + ((_e25305 - 1i) * _e25309)) + _e25312);
let _e25315 = (bitcast<i32>(_e302) - 1i);
let _e25317 = select(_e25315, _e25313, (_e25313 < _e25315));
let _e25322 = global_7.member[bitcast<u32>(select(0i, _e25317, (_e25317 > 0i)))];
phi_7416_ = _e25322;
} else {
phi_7416_ = 0f;
}
let _e25324 = phi_7416_;
let _e25325 = local_209;
let _e25326 = local_211;
let _e25329 = local_210;
let _e25330 = ((_e25325 + (_e25305 * _e25326)) + _e25329);
let _e25332 = (bitcast<i32>(_e302) - 1i);
let _e25334 = select(_e25332, _e25330, (_e25330 < _e25332));
let _e25339 = global_7.member[bitcast<u32>(select(0i, _e25334, (_e25334 > 0i)))];
let _e25346 = (_e24791 - _e24780);
let _e25349 = ((_e24915 - _e24780) / select(1e-9f, _e25346, (_e25346 > 1e-9f)));
local_206 = 0i;
local_207 = _e24800;
local_208 = _e24766;
let _e25351 = select(0f, _e25349, (_e25349 > 0f));
let _e25354 = (select(1f, _e25351, (_e25351 < 1f)) * _e25282);
let _e25356 = select(0f, _e25354, (_e25354 > 0f));
let _e25358 = select(_e25290, _e25356, (_e25356 < _e25290));
let _e25365 = select(0i, select(select(i32(_e25358), i32(-2147483648), (_e25358 < -2147483600f)), 2147483647i, (_e25358 > 2147483500f)), (_e25358 == _e25358));
let _e25369 = (_e25365 - select(0i, 1i, (_e25358 < f32(_e25365))));
if (_e25369 > 0i) {
let _e25372 = local_206;
let _e25373 = local_208;
let _e25376 = local_207;
let _e25377 = ((_e25372 + ((_e25369 - 1i) * _e25373)) + _e25376);
let _e25379 = select(_e25332, _e25377, (_e25377 < _e25332));
let _e25384 = global_7.member[bitcast<u32>(select(0i, _e25379, (_e25379 > 0i)))];
phi_7543_ = _e25384;
} else {
phi_7543_ = 0f;
}
let _e25386 = phi_7543_;
let _e25387 = local_206;
let _e25388 = local_208;
let _e25391 = local_207;
let _e25392 = ((_e25387 + (_e25369 * _e25388)) + _e25391);
let _e25394 = select(_e25332, _e25392, (_e25392 < _e25332));
let _e25399 = global_7.member[bitcast<u32>(select(0i, _e25394, (_e25394 > 0i)))];
let _e25405 = ((_e25324 + ((_e25339 - _e25324) * (_e25287 - f32(_e25305)))) + (_e25386 + ((_e25399 - _e25386) * (_e25354 - f32(_e25369)))));
let _e25408 = global_1.member.member_13.member;
let _e25413 = -((_e25408.member * _e25405));
let _e25415 = select(-87f, _e25413, (_e25413 > -87f));
let _e25417 = select(88f, _e25415, (_e25415 < 88f));
let _e25419 = ((_e25417 * 1.442695f) + 0.5f);
let _e25421 = select(-127f, _e25419, (_e25419 > -127f));
let _e25423 = select(128f, _e25421, (_e25421 < 128f));
let _e25430 = select(0i, select(select(i32(_e25423), i32(-2147483648), (_e25423 < -2147483600f)), 2147483647i, (_e25423 > 2147483500f)), (_e25423 == _e25423));
let _e25434 = (_e25430 - select(0i, 1i, (_e25423 < f32(_e25430))));
let _e25435 = f32(_e25434);
let _e25439 = ((_e25417 - (_e25435 * 0.6933594f)) - (_e25435 * -2.1219444e-4f));
let _e25461 = -((_e25408.member_1 * _e25405));
let _e25463 = select(-87f, _e25461, (_e25461 > -87f));
let _e25465 = select(88f, _e25463, (_e25463 < 88f));
let _e25467 = ((_e25465 * 1.442695f) + 0.5f);
let _e25469 = select(-127f, _e25467, (_e25467 > -127f));
let _e25471 = select(128f, _e25469, (_e25469 < 128f));
let _e25478 = select(0i, select(select(i32(_e25471), i32(-2147483648), (_e25471 < -2147483600f)), 2147483647i, (_e25471 > 2147483500f)), (_e25471 == _e25471));
let _e25482 = (_e25478 - select(0i, 1i, (_e25471 < f32(_e25478))));
let _e25483 = f32(_e25482);
let _e25487 = ((_e25465 - (_e25483 * 0.6933594f)) - (_e25483 * -2.1219444e-4f));
let _e25509 = -((_e25408.member_2 * _e25405));
let _e25511 = select(-87f, _e25509, (_e25509 > -87f));
let _e25513 = select(88f, _e25511, (_e25511 < 88f));
let _e25515 = ((_e25513 * 1.442695f) + 0.5f);
let _e25517 = select(-127f, _e25515, (_e25515 > -127f));
let _e25519 = select(128f, _e25517, (_e25517 < 128f));
let _e25526 = select(0i, select(select(i32(_e25519), i32(-2147483648), (_e25519 < -2147483600f)), 2147483647i, (_e25519 > 2147483500f)), (_e25519 == _e25519));
let _e25530 = (_e25526 - select(0i, 1i, (_e25519 < f32(_e25526))));
let _e25531 = f32(_e25530);
let _e25535 = ((_e25513 - (_e25531 * 0.6933594f)) - (_e25531 * -2.1219444e-4f));
let _e25558 = global_1.member.member_13.member_1;
let _e25571 = select(0f, _e24915, (((_e24918 >= 0f) && (_e24918 < _e725)) && (_e24915 > 0f)));
if _e487 {
phi_7807_ = type_26(_e24708, _e24616);
} else {
phi_7807_ = type_26(_e24616, _e24708);
}
let _e25582 = phi_7807_;
let _e25585 = (_e24709 && (((_e25571 > 0f) && (_e25571 < _e24799)) && true));
let _e25588 = global_1.member.member_18.member;
let _e25589 = (((select(_e24734, (1f - _e24734), (_e24719 >= 0f)) - select(_e24753, (1f - _e24753), (_e24738 >= 0f))) * (1f / _e24716)) * _e25588);
let _e25593 = select(0f, (((((_e686 * _e25558.member) * ((1f + (_e25439 * (1f + (_e25439 * (0.5f + (_e25439 * (0.16666667f + (_e25439 * (0.041666668f + (_e25439 * (0.008333334f + (_e25439 * (0.001388889f + (_e25439 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e25434 + 127i)) << bitcast<u32>(23i))))) * _e25261) * 1f) * _e25589), _e25585);
let _e25594 = select(0f, (((((_e699 * _e25558.member_1) * ((1f + (_e25487 * (1f + (_e25487 * (0.5f + (_e25487 * (0.16666667f + (_e25487 * (0.041666668f + (_e25487 * (0.008333334f + (_e25487 * (0.001388889f + (_e25487 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e25482 + 127i)) << bitcast<u32>(23i))))) * _e25261) * 1f) * _e25589), _e25585);
let _e25595 = select(0f, (((((_e712 * _e25558.member_2) * ((1f + (_e25535 * (1f + (_e25535 * (0.5f + (_e25535 * (0.16666667f + (_e25535 * (0.041666668f + (_e25535 * (0.008333334f + (_e25535 * (0.001388889f + (_e25535 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e25530 + 127i)) << bitcast<u32>(23i))))) * _e25261) * 1f) * _e25589), _e25585);
let _e25599 = (bitcast<f32>((bitcast<u32>(_e25593) & 2147483647u)) >= 1073741800f);
let _e25600 = (1f / 1048576f);
let _e25603 = ((_e25593 * select(1f, _e25600, _e25599)) + 0.5f);
let _e25605 = select(-1073741800f, _e25603, (_e25603 > -1073741800f));
let _e25607 = select(1073741800f, _e25605, (_e25605 < 1073741800f));
let _e25614 = select(0i, select(select(i32(_e25607), i32(-2147483648), (_e25607 < -2147483600f)), 2147483647i, (_e25607 > 2147483500f)), (_e25607 == _e25607));
let _e25618 = (_e25614 - select(0i, 1i, (_e25607 < f32(_e25614))));
let _e25619 = select(0i, 20i, _e25599);
let _e25623 = (bitcast<u32>(_e25618) << bitcast<u32>((_e25619 & 31i)));
let _e25630 = bitcast<u32>(((_e25618 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e25619) & 31i))));
let _e25634 = (bitcast<f32>((bitcast<u32>(_e25594) & 2147483647u)) >= 1073741800f);
let _e25637 = ((_e25594 * select(1f, _e25600, _e25634)) + 0.5f);
let _e25639 = select(-1073741800f, _e25637, (_e25637 > -1073741800f));
let _e25641 = select(1073741800f, _e25639, (_e25639 < 1073741800f));
let _e25648 = select(0i, select(select(i32(_e25641), i32(-2147483648), (_e25641 < -2147483600f)), 2147483647i, (_e25641 > 2147483500f)), (_e25641 == _e25641));
let _e25652 = (_e25648 - select(0i, 1i, (_e25641 < f32(_e25648))));
let _e25653 = select(0i, 20i, _e25634);
let _e25657 = (bitcast<u32>(_e25652) << bitcast<u32>((_e25653 & 31i)));
let _e25664 = bitcast<u32>(((_e25652 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e25653) & 31i))));
let _e25668 = (bitcast<f32>((bitcast<u32>(_e25595) & 2147483647u)) >= 1073741800f);
let _e25671 = ((_e25595 * select(1f, _e25600, _e25668)) + 0.5f);
let _e25673 = select(-1073741800f, _e25671, (_e25671 > -1073741800f));
let _e25675 = select(1073741800f, _e25673, (_e25673 < 1073741800f));
let _e25682 = select(0i, select(select(i32(_e25675), i32(-2147483648), (_e25675 < -2147483600f)), 2147483647i, (_e25675 > 2147483500f)), (_e25675 == _e25675));
let _e25686 = (_e25682 - select(0i, 1i, (_e25675 < f32(_e25682))));
let _e25687 = select(0i, 20i, _e25668);
let _e25691 = (bitcast<u32>(_e25686) << bitcast<u32>((_e25687 & 31i)));
let _e25698 = bitcast<u32>(((_e25686 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e25687) & 31i))));
let _e25703 = bitcast<i32>(bitcast<u32>((((_e25582.member_1 * _e11947) + _e25582.member) * 6i)));
if ((_e25623 | _e25630) == 0u) {
} else {
let _e25706 = bitcast<u32>(_e25703);
if (_e25706 < _e304) {
let _e25710 = atomicAdd((&global_8.member[_e25706]), _e25623);
phi_8040_ = _e25710;
} else {
phi_8040_ = 0u;
}
let _e25712 = phi_8040_;
let _e25716 = (_e25630 + select(0u, 1u, ((_e25712 + _e25623) < _e25623)));
if (_e25716 == 0u) {
} else {
let _e25718 = (_e25706 + 1u);
if (_e25718 < _e304) {
let _e25722 = atomicAdd((&global_8.member[_e25718]), _e25716);
}
}
}
if ((_e25657 | _e25664) == 0u) {
} else {
let _e25726 = bitcast<u32>((_e25703 + 2i));
if (_e25726 < _e304) {
let _e25730 = atomicAdd((&global_8.member[_e25726]), _e25657);
phi_8070_ = _e25730;
} else {
phi_8070_ = 0u;
}
let _e25732 = phi_8070_;
let _e25736 = (_e25664 + select(0u, 1u, ((_e25732 + _e25657) < _e25657)));
if (_e25736 == 0u) {
} else {
let _e25738 = (_e25726 + 1u);
if (_e25738 < _e304) {
let _e25742 = atomicAdd((&global_8.member[_e25738]), _e25736);
}
}
}
if ((_e25691 | _e25698) == 0u) {
} else {
let _e25746 = bitcast<u32>((_e25703 + 4i));
if (_e25746 < _e304) {
let _e25750 = atomicAdd((&global_8.member[_e25746]), _e25691);
phi_8100_ = _e25750;
} else {
phi_8100_ = 0u;
}
let _e25752 = phi_8100_;
let _e25756 = (_e25698 + select(0u, 1u, ((_e25752 + _e25691) < _e25691)));
if (_e25756 == 0u) {
} else {
let _e25758 = (_e25746 + 1u);
if (_e25758 < _e304) {
let _e25762 = atomicAdd((&global_8.member[_e25758]), _e25756);
}
}
}
phi_6422_ = (_e24706 + 1i);
} else {
phi_6422_ = i32();
}
let _e25765 = phi_6422_;
continue;
continuing {
phi_6421_ = _e25765;
break if !(_e24709);
}
}
phi_6268_ = (_e24613 + 1i);
} else {
phi_6268_ = i32();
}
let _e25769 = phi_6268_;
continue;
continuing {
phi_6267_ = _e25769;
break if !(_e24614);
}
}
} else {
if (_e19568 == 1u) {
phi_8149_ = 0i;
loop {
let _e22762 = phi_8149_;
let _e22763 = (_e22762 < 16i);
if _e22763 {
let _e22765 = (_e11992 + (_e22762 & 15i));
let _e22767 = (f32(_e22765) + 0.5f);
let _e22769 = ((_e22767 * 1f) - 0.5f);
let _e22773 = (-(((_e450 * _e22769) + _e476)) / _e463);
let _e22780 = bitcast<f32>((bitcast<u32>(((_e500 * _e22769) + ((_e513 * _e22773) + _e526))) & 2147483647u));
let _e22787 = bitcast<f32>((bitcast<u32>(((_e539 * _e22769) + ((_e552 * _e22773) + _e565))) & 2147483647u));
let _e22791 = (((0.5f * (_e22780 + _e22787)) / _e568) + _e751);
let _e22792 = (1f / 1f);
let _e22800 = ((((_e22773 + _e22791) + 0.5f) * _e22792) - 0.5f);
let _e22801 = f32(_e11997);
let _e22802 = (0f - 1f);
let _e22804 = select(_e22802, _e22800, (_e22800 > _e22802));
let _e22806 = select(_e22801, _e22804, (_e22804 < _e22801));
let _e22813 = select(0i, select(select(i32(_e22806), i32(-2147483648), (_e22806 < -2147483600f)), 2147483647i, (_e22806 > 2147483500f)), (_e22806 == _e22806));
let _e22818 = (((((_e22773 - _e22791) + 0.5f) * _e22792) - 0.5f) + 1f);
let _e22819 = (_e22801 + 1f);
let _e22821 = select(0f, _e22818, (_e22818 > 0f));
let _e22823 = select(_e22819, _e22821, (_e22821 < _e22819));
let _e22830 = select(0i, select(select(i32(_e22823), i32(-2147483648), (_e22823 < -2147483600f)), 2147483647i, (_e22823 > 2147483500f)), (_e22823 == _e22823));
let _e22841 = ((1e-4f * 1f) * _e568);
let _e22843 = select(_e22787, _e22780, (_e22780 > _e22787));
let _e22845 = select(_e22841, _e22843, (_e22843 > _e22841));
let _e22847 = select(_e22787, _e22780, (_e22780 < _e22787));
let _e22849 = select(_e22841, _e22847, (_e22847 > _e22841));
let _e22851 = (0.5f * (_e22845 + _e22849));
let _e22852 = (0.5f / _e22849);
let _e22853 = (1f / _e22845);
phi_8303_ = 0i;
loop {
let _e22855 = phi_8303_;
let _e22857 = (((_e22830 - select(0i, 1i, (_e22823 < f32(_e22830)))) + (_e22762 >> bitcast<u32>(4u))) + bitcast<i32>(_e22855));
let _e22858 = (_e22857 <= select(-1i, (_e22813 - select(0i, 1i, (_e22806 < f32(_e22813)))), (_e22765 <= _e11996)));
if _e22858 {
let _e22860 = (f32(_e22857) + 0.5f);
let _e22864 = ((((_e22860 * 1f) - 0.5f) - _e22773) * _e568);
let _e22865 = (_e568 * 1f);
let _e22867 = (0.5f * _e22865);
let _e22868 = (_e22864 + _e22867);
let _e22869 = -(_e22868);
let _e22872 = (_e22851 - select(_e22869, _e22868, (_e22868 > _e22869)));
let _e22874 = select(0f, _e22872, (_e22872 > 0f));
let _e22876 = select(_e22849, _e22874, (_e22874 < _e22849));
let _e22879 = (_e22872 - _e22849);
let _e22883 = (((_e22876 * (_e22876 * _e22852)) + select(0f, _e22879, (_e22879 > 0f))) * _e22853);
let _e22887 = (_e22864 - _e22867);
let _e22888 = -(_e22887);
let _e22891 = (_e22851 - select(_e22888, _e22887, (_e22887 > _e22888)));
let _e22893 = select(0f, _e22891, (_e22891 > 0f));
let _e22895 = select(_e22849, _e22893, (_e22893 < _e22849));
let _e22898 = (_e22891 - _e22849);
let _e22902 = (((_e22895 * (_e22895 * _e22852)) + select(0f, _e22898, (_e22898 > 0f))) * _e22853);
if _e487 {
phi_8408_ = type_26(_e22857, _e22765);
} else {
phi_8408_ = type_26(_e22765, _e22857);
}
let _e22911 = phi_8408_;
let _e22915 = bitcast<i32>((_e11943 * _e11946));
local_204 = _e22915;
local_205 = ((_e22911.member_1 * _e11947) + _e22911.member);
let _e22918 = local_204;
let _e22919 = local_205;
let _e22920 = (_e22918 + _e22919);
let _e22922 = (bitcast<i32>(_e293) - 1i);
let _e22924 = select(_e22922, _e22920, (_e22920 < _e22922));
let _e22929 = global_5.member[bitcast<u32>(select(0i, _e22924, (_e22924 > 0i)))];
let _e22930 = local_204;
let _e22932 = local_205;
let _e22933 = ((2i * _e22930) + _e22932);
let _e22935 = select(_e22922, _e22933, (_e22933 < _e22922));
let _e22940 = global_5.member[bitcast<u32>(select(0i, _e22935, (_e22935 > 0i)))];
let _e22941 = local_205;
let _e22943 = select(_e22922, _e22941, (_e22941 < _e22922));
let _e22948 = global_5.member[bitcast<u32>(select(0i, _e22943, (_e22943 > 0i)))];
let _e22949 = local_205;
let _e22952 = f32(_e11947);
let _e22953 = f32(_e11948);
let _e22960 = global_1.member.member_2.member;
let _e22961 = (((((f32(_e22911.member) + 0.5f) / _e22952) * 2f) - 1f) * _e22960);
let _e22968 = global_1.member.member_2.member_1;
let _e22969 = ((1f - (((f32(_e22911.member_1) + 0.5f) / _e22953) * 2f)) * _e22968);
let _e22971 = global_1.member.member_3;
let _e22979 = global_1.member.member_4;
let _e22986 = ((_e22971.member * _e22961) + (_e22979.member * _e22969));
let _e22987 = ((_e22971.member_1 * _e22961) + (_e22979.member_1 * _e22969));
let _e22988 = ((_e22971.member_2 * _e22961) + (_e22979.member_2 * _e22969));
let _e22991 = global_1.member.member_2.member_3;
let _e22992 = (_e22991 != 0u);
let _e22994 = global_1.member.member_5;
let _e23001 = select((_e22994.member + _e22986), _e22994.member, _e22992);
let _e23002 = select((_e22994.member_1 + _e22987), _e22994.member_1, _e22992);
let _e23003 = select((_e22994.member_2 + _e22988), _e22994.member_2, _e22992);
let _e23005 = global_1.member.member_6;
let _e23012 = select(_e23005.member, (_e23005.member + _e22986), _e22992);
let _e23013 = select(_e23005.member_1, (_e23005.member_1 + _e22987), _e22992);
let _e23014 = select(_e23005.member_2, (_e23005.member_2 + _e22988), _e22992);
let _e23019 = (((_e23001 * _e23001) + (_e23002 * _e23002)) + (_e23003 * _e23003));
let _e23022 = sqrt(select(0f, _e23019, (_e23019 > 0f)));
let _e23023 = (1f / _e23022);
let _e23024 = (_e23001 * _e23023);
let _e23025 = (_e23002 * _e23023);
let _e23026 = (_e23003 * _e23023);
let _e23027 = (_e609 - _e23012);
let _e23028 = (_e621 - _e23013);
let _e23029 = (_e634 - _e23014);
let _e23034 = (((_e23027 * _e23024) + (_e23028 * _e23025)) + (_e23029 * _e23026));
let _e23039 = (((_e23027 * _e647) + (_e23028 * _e660)) + (_e23029 * _e673));
let _e23044 = (((_e23024 * _e647) + (_e23025 * _e660)) + (_e23026 * _e673));
let _e23047 = ((_e23025 * _e673) - (_e23026 * _e660));
let _e23050 = ((_e23026 * _e647) - (_e23024 * _e673));
let _e23053 = ((_e23024 * _e660) - (_e23025 * _e647));
let _e23058 = (((_e23047 * _e23047) + (_e23050 * _e23050)) + (_e23053 * _e23053));
let _e23061 = (1f / select(1e-9f, _e23058, (_e23058 > 1e-9f)));
let _e23064 = ((_e23034 - (_e23044 * _e23039)) * _e23061);
let _e23067 = (((_e23044 * _e23034) - _e23039) * _e23061);
let _e23073 = -(_e23044);
let _e23076 = global_1.member.member_13.member_2;
let _e23077 = (_e23076 * _e23076);
let _e23081 = ((1f + _e23077) - ((2f * _e23076) * _e23073));
let _e23083 = select(1e-9f, _e23081, (_e23081 > 1e-9f));
let _e23095 = global_1.member.member_13.member_3;
if (_e23095 == 2u) {
let _e23100 = (0.5f - (0.5f * _e23073));
let _e23102 = select(0f, _e23100, (_e23100 > 0f));
let _e23106 = (sqrt(select(0f, _e23102, (_e23102 > 0f))) * 255f);
let _e23107 = (255f - 1f);
let _e23109 = select(0f, _e23106, (_e23106 > 0f));
let _e23111 = select(_e23107, _e23109, (_e23109 < _e23107));
let _e23118 = select(0i, select(select(i32(_e23111), i32(-2147483648), (_e23111 < -2147483600f)), 2147483647i, (_e23111 > 2147483500f)), (_e23111 == _e23111));
let _e23122 = (_e23118 - select(0i, 1i, (_e23111 < f32(_e23118))));
let _e23125 = global_1.member.member_13.member_11;
let _e23126 = bitcast<i32>(_e23125);
let _e23127 = (_e23126 + _e23122);
let _e23129 = (bitcast<i32>(_e299) - 1i);
let _e23131 = select(_e23129, _e23127, (_e23127 < _e23129));
let _e23136 = global_2.member[bitcast<u32>(select(0i, _e23131, (_e23131 > 0i)))];
let _e23138 = (_e23126 + (_e23122 + 1i));
let _e23140 = select(_e23129, _e23138, (_e23138 < _e23129));
let _e23145 = global_2.member[bitcast<u32>(select(0i, _e23140, (_e23140 > 0i)))];
phi_8835_ = (_e23136 + ((_e23145 - _e23136) * (_e23106 - f32(_e23122))));
} else {
phi_8835_ = select(((1f - _e23077) / (_e23083 * sqrt(select(0f, _e23083, (_e23083 > 0f))))), (0.75f * (1f + (_e23073 * _e23073))), (_e23095 == 1u));
}
let _e23152 = phi_8835_;
let _e23164 = global_1.member.member_13.member_7;
let _e23165 = bitcast<i32>(_e23164);
let _e23168 = global_1.member.member_13.member_8;
let _e23169 = bitcast<i32>(_e23168);
let _e23172 = global_1.member.member_13.member_9;
let _e23173 = bitcast<i32>(_e23172);
let _e23176 = global_1.member.member_13.member_4;
let _e23182 = global_1.member.member_13.member_5;
let _e23186 = f32(_e23165);
let _e23191 = (((((_e23012 + (_e23024 * _e23064)) - _e23176.member) / (_e23182.member - _e23176.member)) * _e23186) - 0.5f);
let _e23192 = (_e23186 - 1f);
let _e23194 = select(0f, _e23191, (_e23191 > 0f));
let _e23196 = select(_e23192, _e23194, (_e23194 < _e23192));
let _e23197 = f32(_e23169);
let _e23202 = (((((_e23013 + (_e23025 * _e23064)) - _e23176.member_1) / (_e23182.member_1 - _e23176.member_1)) * _e23197) - 0.5f);
let _e23203 = (_e23197 - 1f);
let _e23205 = select(0f, _e23202, (_e23202 > 0f));
let _e23207 = select(_e23203, _e23205, (_e23205 < _e23203));
let _e23208 = f32(_e23173);
let _e23213 = (((((_e23014 + (_e23026 * _e23064)) - _e23176.member_2) / (_e23182.member_2 - _e23176.member_2)) * _e23208) - 0.5f);
let _e23214 = (_e23208 - 1f);
let _e23216 = select(0f, _e23213, (_e23213 > 0f));
let _e23218 = select(_e23214, _e23216, (_e23216 < _e23214));
let _e23220 = select(0f, _e23196, (_e23196 > 0f));
let _e23222 = select(1e6f, _e23220, (_e23220 < 1e6f));
let _e23229 = select(0i, select(select(i32(_e23222), i32(-2147483648), (_e23222 < -2147483600f)), 2147483647i, (_e23222 > 2147483500f)), (_e23222 == _e23222));
let _e23233 = (_e23229 - select(0i, 1i, (_e23222 < f32(_e23229))));
let _e23235 = select(0f, _e23207, (_e23207 > 0f));
let _e23237 = select(1e6f, _e23235, (_e23235 < 1e6f));
let _e23244 = select(0i, select(select(i32(_e23237), i32(-2147483648), (_e23237 < -2147483600f)), 2147483647i, (_e23237 > 2147483500f)), (_e23237 == _e23237));
let _e23248 = (_e23244 - select(0i, 1i, (_e23237 < f32(_e23244))));
let _e23250 = select(0f, _e23218, (_e23218 > 0f));
let _e23252 = select(1e6f, _e23250, (_e23250 < 1e6f));
let _e23259 = select(0i, select(select(i32(_e23252), i32(-2147483648), (_e23252 < -2147483600f)), 2147483647i, (_e23252 > 2147483500f)), (_e23252 == _e23252));
let _e23263 = (_e23259 - select(0i, 1i, (_e23252 < f32(_e23259))));
let _e23267 = (_e23207 - f32(_e23248));
let _e23269 = (_e23218 - f32(_e23263));
local_202 = (_e23196 - f32(_e23233));
let _e23270 = (_e23233 + 1i);
let _e23272 = select(_e23270, 0i, (_e23270 < 0i));
if (_e23272 >= _e23165) {
phi_8967_ = (_e23165 - 1i);
} else {
phi_8967_ = _e23272;
}
let _e23276 = phi_8967_;
local_203 = (_e23276 - _e23233);
let _e23278 = (_e23248 + 1i);
let _e23280 = select(_e23278, 0i, (_e23278 < 0i));
if (_e23280 >= _e23169) {
phi_8980_ = (_e23169 - 1i);
} else {
phi_8980_ = _e23280;
}
let _e23284 = phi_8980_;
let _e23286 = ((_e23284 - _e23248) * _e23165);
let _e23287 = (_e23263 + 1i);
let _e23289 = select(_e23287, 0i, (_e23287 < 0i));
if (_e23289 >= _e23173) {
phi_8994_ = (_e23173 - 1i);
} else {
phi_8994_ = _e23289;
}
let _e23293 = phi_8994_;
let _e23299 = global_1.member.member_13.member_10;
let _e23305 = ((bitcast<i32>(_e23299) + (((_e23263 * _e23169) + _e23248) * _e23165)) + _e23233);
let _e23307 = (bitcast<i32>(_e299) - 1i);
let _e23309 = select(_e23307, _e23305, (_e23305 < _e23307));
let _e23314 = global_2.member[bitcast<u32>(select(0i, _e23309, (_e23309 > 0i)))];
let _e23315 = local_202;
let _e23318 = local_203;
let _e23319 = (_e23305 + _e23318);
let _e23321 = select(_e23307, _e23319, (_e23319 < _e23307));
let _e23326 = global_2.member[bitcast<u32>(select(0i, _e23321, (_e23321 > 0i)))];
let _e23327 = local_202;
let _e23330 = (1f - _e23267);
let _e23332 = (_e23305 + _e23286);
let _e23334 = select(_e23307, _e23332, (_e23332 < _e23307));
let _e23339 = global_2.member[bitcast<u32>(select(0i, _e23334, (_e23334 > 0i)))];
let _e23340 = local_202;
let _e23343 = local_203;
let _e23344 = (_e23332 + _e23343);
let _e23346 = select(_e23307, _e23344, (_e23344 < _e23307));
let _e23351 = global_2.member[bitcast<u32>(select(0i, _e23346, (_e23346 > 0i)))];
let _e23352 = local_202;
let _e23357 = (_e23305 + (((_e23293 - _e23263) * _e23165) * _e23169));
let _e23359 = select(_e23307, _e23357, (_e23357 < _e23307));
let _e23364 = global_2.member[bitcast<u32>(select(0i, _e23359, (_e23359 > 0i)))];
let _e23365 = local_202;
let _e23368 = local_203;
let _e23369 = (_e23357 + _e23368);
let _e23371 = select(_e23307, _e23369, (_e23369 < _e23307));
let _e23376 = global_2.member[bitcast<u32>(select(0i, _e23371, (_e23371 > 0i)))];
let _e23377 = local_202;
let _e23381 = (_e23357 + _e23286);
let _e23383 = select(_e23307, _e23381, (_e23381 < _e23307));
let _e23388 = global_2.member[bitcast<u32>(select(0i, _e23383, (_e23383 > 0i)))];
let _e23389 = local_202;
let _e23392 = local_203;
let _e23393 = (_e23381 + _e23392);
let _e23395 = select(_e23307, _e23393, (_e23393 < _e23307));
let _e23400 = global_2.member[bitcast<u32>(select(0i, _e23395, (_e23395 > 0i)))];
let _e23401 = local_202;
let _e23410 = ((_e23022 * (_e23152 * (0.25f / 3.1415927f))) * ((((((_e23314 * (1f - _e23315)) + (_e23326 * _e23327)) * _e23330) + (((_e23339 * (1f - _e23340)) + (_e23351 * _e23352)) * _e23267)) * (1f - _e23269)) + (((((_e23364 * (1f - _e23365)) + (_e23376 * _e23377)) * _e23330) + (((_e23388 * (1f - _e23389)) + (_e23400 * _e23401)) * _e23267)) * _e23269)));
let _e23413 = global_1.member.member_12.member_12;
let _e23416 = global_1.member.member_12.member_4;
let _e23419 = global_1.member.member_12.member_13;
let _e23425 = global_1.member.member.member;
let _e23427 = (_e23067 / _e725);
local_199 = bitcast<i32>((_e23413 + (_e23416 * _e23419)));
local_200 = _e315;
local_201 = bitcast<i32>(_e23425);
let _e23430 = global_1.member.member_13.member_6;
let _e23431 = f32(_e23430);
let _e23433 = select(0f, _e23427, (_e23427 > 0f));
let _e23436 = (select(1f, _e23433, (_e23433 < 1f)) * _e23431);
let _e23437 = (_e23431 - 1f);
let _e23439 = select(0f, _e23437, (_e23437 > 0f));
let _e23441 = select(0f, _e23436, (_e23436 > 0f));
let _e23443 = select(_e23439, _e23441, (_e23441 < _e23439));
let _e23450 = select(0i, select(select(i32(_e23443), i32(-2147483648), (_e23443 < -2147483600f)), 2147483647i, (_e23443 > 2147483500f)), (_e23443 == _e23443));
let _e23454 = (_e23450 - select(0i, 1i, (_e23443 < f32(_e23450))));
if (_e23454 > 0i) {
let _e23457 = local_199;
let _e23458 = local_201;
let _e23461 = local_200;
let _e23462 = ((_e23457 + ((_e23454 - 1i) * _e23458)) + _e23461);
let _e23464 = (bitcast<i32>(_e302) - 1i);
let _e23466 = select(_e23464, _e23462, (_e23462 < _e23464));
let _e23471 = global_7.member[bitcast<u32>(select(0i, _e23466, (_e23466 > 0i)))];
phi_9298_ = _e23471;
} else {
phi_9298_ = 0f;
}
let _e23473 = phi_9298_;
let _e23474 = local_199;
let _e23475 = local_201;
let _e23478 = local_200;
let _e23479 = ((_e23474 + (_e23454 * _e23475)) + _e23478);
let _e23481 = (bitcast<i32>(_e302) - 1i);
let _e23483 = select(_e23481, _e23479, (_e23479 < _e23481));
let _e23488 = global_7.member[bitcast<u32>(select(0i, _e23483, (_e23483 > 0i)))];
let _e23495 = (_e22940 - _e22929);
let _e23498 = ((_e23064 - _e22929) / select(1e-9f, _e23495, (_e23495 > 1e-9f)));
local_196 = 0i;
local_197 = _e22949;
local_198 = _e22915;
let _e23500 = select(0f, _e23498, (_e23498 > 0f));
let _e23503 = (select(1f, _e23500, (_e23500 < 1f)) * _e23431);
let _e23505 = select(0f, _e23503, (_e23503 > 0f));
let _e23507 = select(_e23439, _e23505, (_e23505 < _e23439));
let _e23514 = select(0i, select(select(i32(_e23507), i32(-2147483648), (_e23507 < -2147483600f)), 2147483647i, (_e23507 > 2147483500f)), (_e23507 == _e23507));
let _e23518 = (_e23514 - select(0i, 1i, (_e23507 < f32(_e23514))));
if (_e23518 > 0i) {
let _e23521 = local_196;
let _e23522 = local_198;
let _e23525 = local_197;
let _e23526 = ((_e23521 + ((_e23518 - 1i) * _e23522)) + _e23525);
let _e23528 = select(_e23481, _e23526, (_e23526 < _e23481));
let _e23533 = global_7.member[bitcast<u32>(select(0i, _e23528, (_e23528 > 0i)))];
phi_9425_ = _e23533;
} else {
phi_9425_ = 0f;
}
let _e23535 = phi_9425_;
let _e23536 = local_196;
let _e23537 = local_198;
let _e23540 = local_197;
let _e23541 = ((_e23536 + (_e23518 * _e23537)) + _e23540);
let _e23543 = select(_e23481, _e23541, (_e23541 < _e23481));
let _e23548 = global_7.member[bitcast<u32>(select(0i, _e23543, (_e23543 > 0i)))];
let _e23554 = ((_e23473 + ((_e23488 - _e23473) * (_e23436 - f32(_e23454)))) + (_e23535 + ((_e23548 - _e23535) * (_e23503 - f32(_e23518)))));
let _e23557 = global_1.member.member_13.member;
let _e23562 = -((_e23557.member * _e23554));
let _e23564 = select(-87f, _e23562, (_e23562 > -87f));
let _e23566 = select(88f, _e23564, (_e23564 < 88f));
let _e23568 = ((_e23566 * 1.442695f) + 0.5f);
let _e23570 = select(-127f, _e23568, (_e23568 > -127f));
let _e23572 = select(128f, _e23570, (_e23570 < 128f));
let _e23579 = select(0i, select(select(i32(_e23572), i32(-2147483648), (_e23572 < -2147483600f)), 2147483647i, (_e23572 > 2147483500f)), (_e23572 == _e23572));
let _e23583 = (_e23579 - select(0i, 1i, (_e23572 < f32(_e23579))));
let _e23584 = f32(_e23583);
let _e23588 = ((_e23566 - (_e23584 * 0.6933594f)) - (_e23584 * -2.1219444e-4f));
let _e23610 = -((_e23557.member_1 * _e23554));
let _e23612 = select(-87f, _e23610, (_e23610 > -87f));
let _e23614 = select(88f, _e23612, (_e23612 < 88f));
let _e23616 = ((_e23614 * 1.442695f) + 0.5f);
let _e23618 = select(-127f, _e23616, (_e23616 > -127f));
let _e23620 = select(128f, _e23618, (_e23618 < 128f));
let _e23627 = select(0i, select(select(i32(_e23620), i32(-2147483648), (_e23620 < -2147483600f)), 2147483647i, (_e23620 > 2147483500f)), (_e23620 == _e23620));
let _e23631 = (_e23627 - select(0i, 1i, (_e23620 < f32(_e23627))));
let _e23632 = f32(_e23631);
let _e23636 = ((_e23614 - (_e23632 * 0.6933594f)) - (_e23632 * -2.1219444e-4f));
let _e23658 = -((_e23557.member_2 * _e23554));
let _e23660 = select(-87f, _e23658, (_e23658 > -87f));
let _e23662 = select(88f, _e23660, (_e23660 < 88f));
let _e23664 = ((_e23662 * 1.442695f) + 0.5f);
let _e23666 = select(-127f, _e23664, (_e23664 > -127f));
let _e23668 = select(128f, _e23666, (_e23666 < 128f));
let _e23675 = select(0i, select(select(i32(_e23668), i32(-2147483648), (_e23668 < -2147483600f)), 2147483647i, (_e23668 > 2147483500f)), (_e23668 == _e23668));
let _e23679 = (_e23675 - select(0i, 1i, (_e23668 < f32(_e23675))));
let _e23680 = f32(_e23679);
let _e23684 = ((_e23662 - (_e23680 * 0.6933594f)) - (_e23680 * -2.1219444e-4f));
let _e23707 = global_1.member.member_13.member_1;
let _e23720 = select(0f, _e23064, (((_e23067 >= 0f) && (_e23067 < _e725)) && (_e23064 > 0f)));
let _e23722 = ((_e800 + _e19556) + _e19560);
let _e23723 = (_e23722 & 31u);
let _e23725 = (1u << bitcast<u32>(_e23723));
let _e23734 = bitcast<i32>((((_e11943 + _e23725) - 1u) >> bitcast<u32>(_e23723)));
let _e23735 = bitcast<i32>((((_e11946 + _e23725) - 1u) >> bitcast<u32>(_e23723)));
if _e487 {
phi_9715_ = type_26(_e23735, _e23734);
} else {
phi_9715_ = type_26(_e23734, _e23735);
}
let _e23739 = phi_9715_;
let _e23744 = f32((1i << bitcast<u32>(_e23723)));
let _e23745 = (1f / _e23744);
let _e23747 = ((_e22767 * _e23745) - 0.5f);
let _e23749 = ((_e22860 * _e23745) - 0.5f);
let _e23751 = select(-1f, _e23747, (_e23747 > -1f));
let _e23753 = select(1e6f, _e23751, (_e23751 < 1e6f));
let _e23760 = select(0i, select(select(i32(_e23753), i32(-2147483648), (_e23753 < -2147483600f)), 2147483647i, (_e23753 > 2147483500f)), (_e23753 == _e23753));
let _e23764 = (_e23760 - select(0i, 1i, (_e23753 < f32(_e23760))));
let _e23766 = select(-1f, _e23749, (_e23749 > -1f));
let _e23768 = select(1e6f, _e23766, (_e23766 < 1e6f));
let _e23775 = select(0i, select(select(i32(_e23768), i32(-2147483648), (_e23768 < -2147483600f)), 2147483647i, (_e23768 > 2147483500f)), (_e23768 == _e23768));
let _e23779 = (_e23775 - select(0i, 1i, (_e23768 < f32(_e23775))));
let _e23781 = (_e23747 - f32(_e23764));
let _e23783 = (_e23749 - f32(_e23779));
let _e23784 = (1f - _e23781);
let _e23785 = (1f - _e23783);
let _e23788 = select(_e23764, 0i, (_e23764 < 0i));
let _e23789 = (_e23788 >= _e23739.member);
if _e23789 {
phi_9793_ = (_e23739.member - 1i);
} else {
phi_9793_ = _e23788;
}
let _e23792 = phi_9793_;
let _e23794 = select(_e23779, 0i, (_e23779 < 0i));
let _e23795 = (_e23794 >= _e23739.member_1);
if _e23795 {
phi_9804_ = (_e23739.member_1 - 1i);
} else {
phi_9804_ = _e23794;
}
let _e23798 = phi_9804_;
let _e23802 = (((f32(_e23792) + 0.5f) * _e23744) - 0.5f);
let _e23806 = (((f32(_e23798) + 0.5f) * _e23744) - 0.5f);
if _e487 {
phi_9832_ = type_26(_e23798, _e23792);
} else {
phi_9832_ = type_26(_e23792, _e23798);
}
let _e23812 = phi_9832_;
let _e23818 = bitcast<i32>(((_e11943 + 1u) >> bitcast<u32>(1u)));
let _e23821 = global_1.member.member_18.member_6;
let _e23824 = global_1.member.member_18.member_7;
let _e23827 = global_1.member.member_18.member_8;
let _e23828 = (_e23722 == 0u);
if _e23828 {
phi_9883_ = 0u;
} else {
if (_e23722 == 1u) {
phi_9882_ = 0u;
} else {
if (_e23722 == 2u) {
phi_9881_ = _e23821;
} else {
phi_9881_ = select(_e23827, _e23824, (_e23722 == 3u));
}
let _e23834 = phi_9881_;
phi_9882_ = _e23834;
}
let _e23836 = phi_9882_;
phi_9883_ = _e23836;
}
let _e23838 = phi_9883_;
local_194 = (((bitcast<i32>(_e23838) + _e23812.member_1) * _e23818) + _e23812.member);
let _e23843 = local_194;
let _e23845 = (bitcast<i32>(_e296) - 1i);
let _e23847 = select(_e23845, _e23843, (_e23843 < _e23845));
let _e23852 = global_6.member[bitcast<u32>(select(0i, _e23847, (_e23847 > 0i)))];
let _e23857 = (((((select(_e23802, _e23806, _e487) + 0.5f) / _e22952) * 2f) - 1f) * _e22960);
let _e23862 = ((1f - (((select(_e23806, _e23802, _e487) + 0.5f) / _e22953) * 2f)) * _e22968);
let _e23869 = ((_e22971.member * _e23857) + (_e22979.member * _e23862));
let _e23870 = ((_e22971.member_1 * _e23857) + (_e22979.member_1 * _e23862));
let _e23871 = ((_e22971.member_2 * _e23857) + (_e22979.member_2 * _e23862));
let _e23875 = select((_e22994.member + _e23869), _e22994.member, _e22992);
let _e23876 = select((_e22994.member_1 + _e23870), _e22994.member_1, _e22992);
let _e23877 = select((_e22994.member_2 + _e23871), _e22994.member_2, _e22992);
let _e23888 = (((_e23875 * _e23875) + (_e23876 * _e23876)) + (_e23877 * _e23877));
let _e23892 = (1f / sqrt(select(0f, _e23888, (_e23888 > 0f))));
let _e23893 = (_e23875 * _e23892);
let _e23894 = (_e23876 * _e23892);
let _e23895 = (_e23877 * _e23892);
let _e23896 = (_e609 - select(_e23005.member, (_e23005.member + _e23869), _e22992));
let _e23897 = (_e621 - select(_e23005.member_1, (_e23005.member_1 + _e23870), _e22992));
let _e23898 = (_e634 - select(_e23005.member_2, (_e23005.member_2 + _e23871), _e22992));
let _e23903 = (((_e23896 * _e23893) + (_e23897 * _e23894)) + (_e23898 * _e23895));
let _e23908 = (((_e23896 * _e647) + (_e23897 * _e660)) + (_e23898 * _e673));
let _e23913 = (((_e23893 * _e647) + (_e23894 * _e660)) + (_e23895 * _e673));
let _e23916 = ((_e23894 * _e673) - (_e23895 * _e660));
let _e23919 = ((_e23895 * _e647) - (_e23893 * _e673));
let _e23922 = ((_e23893 * _e660) - (_e23894 * _e647));
let _e23927 = (((_e23916 * _e23916) + (_e23919 * _e23919)) + (_e23922 * _e23922));
let _e23930 = (1f / select(1e-9f, _e23927, (_e23927 > 1e-9f)));
let _e23933 = ((_e23903 - (_e23913 * _e23908)) * _e23930);
let _e23936 = (((_e23913 * _e23903) - _e23908) * _e23930);
let _e23942 = select(0f, _e23933, (((_e23936 >= 0f) && (_e23936 < _e725)) && (_e23933 > 0f)));
let _e23944 = (_e23792 << bitcast<u32>(_e23723));
let _e23956 = (_e23764 + 1i);
let _e23959 = select(_e23956, 0i, (_e23956 < 0i));
let _e23960 = (_e23959 >= _e23739.member);
if _e23960 {
phi_10867_ = (_e23739.member - 1i);
} else {
phi_10867_ = _e23959;
}
let _e23963 = phi_10867_;
if _e23795 {
phi_10878_ = (_e23739.member_1 - 1i);
} else {
phi_10878_ = _e23794;
}
let _e23966 = phi_10878_;
let _e23970 = (((f32(_e23963) + 0.5f) * _e23744) - 0.5f);
let _e23974 = (((f32(_e23966) + 0.5f) * _e23744) - 0.5f);
if _e487 {
phi_10906_ = type_26(_e23966, _e23963);
} else {
phi_10906_ = type_26(_e23963, _e23966);
}
let _e23980 = phi_10906_;
if _e23828 {
phi_10957_ = 0u;
} else {
if (_e23722 == 1u) {
phi_10956_ = 0u;
} else {
if (_e23722 == 2u) {
phi_10955_ = _e23821;
} else {
phi_10955_ = select(_e23827, _e23824, (_e23722 == 3u));
}
let _e23988 = phi_10955_;
phi_10956_ = _e23988;
}
let _e23990 = phi_10956_;
phi_10957_ = _e23990;
}
let _e23992 = phi_10957_;
local_192 = (((bitcast<i32>(_e23992) + _e23980.member_1) * _e23818) + _e23980.member);
let _e23997 = local_192;
let _e23999 = select(_e23845, _e23997, (_e23997 < _e23845));
let _e24004 = global_6.member[bitcast<u32>(select(0i, _e23999, (_e23999 > 0i)))];
let _e24009 = (((((select(_e23970, _e23974, _e487) + 0.5f) / _e22952) * 2f) - 1f) * _e22960);
let _e24014 = ((1f - (((select(_e23974, _e23970, _e487) + 0.5f) / _e22953) * 2f)) * _e22968);
let _e24021 = ((_e22971.member * _e24009) + (_e22979.member * _e24014));
let _e24022 = ((_e22971.member_1 * _e24009) + (_e22979.member_1 * _e24014));
let _e24023 = ((_e22971.member_2 * _e24009) + (_e22979.member_2 * _e24014));
let _e24027 = select((_e22994.member + _e24021), _e22994.member, _e22992);
let _e24028 = select((_e22994.member_1 + _e24022), _e22994.member_1, _e22992);
let _e24029 = select((_e22994.member_2 + _e24023), _e22994.member_2, _e22992);
let _e24040 = (((_e24027 * _e24027) + (_e24028 * _e24028)) + (_e24029 * _e24029));
let _e24044 = (1f / sqrt(select(0f, _e24040, (_e24040 > 0f))));
let _e24045 = (_e24027 * _e24044);
let _e24046 = (_e24028 * _e24044);
let _e24047 = (_e24029 * _e24044);
let _e24048 = (_e609 - select(_e23005.member, (_e23005.member + _e24021), _e22992));
let _e24049 = (_e621 - select(_e23005.member_1, (_e23005.member_1 + _e24022), _e22992));
let _e24050 = (_e634 - select(_e23005.member_2, (_e23005.member_2 + _e24023), _e22992));
let _e24055 = (((_e24048 * _e24045) + (_e24049 * _e24046)) + (_e24050 * _e24047));
let _e24060 = (((_e24048 * _e647) + (_e24049 * _e660)) + (_e24050 * _e673));
let _e24065 = (((_e24045 * _e647) + (_e24046 * _e660)) + (_e24047 * _e673));
let _e24068 = ((_e24046 * _e673) - (_e24047 * _e660));
let _e24071 = ((_e24047 * _e647) - (_e24045 * _e673));
let _e24074 = ((_e24045 * _e660) - (_e24046 * _e647));
let _e24079 = (((_e24068 * _e24068) + (_e24071 * _e24071)) + (_e24074 * _e24074));
let _e24082 = (1f / select(1e-9f, _e24079, (_e24079 > 1e-9f)));
let _e24085 = ((_e24055 - (_e24065 * _e24060)) * _e24082);
let _e24088 = (((_e24065 * _e24055) - _e24060) * _e24082);
let _e24094 = select(0f, _e24085, (((_e24088 >= 0f) && (_e24088 < _e725)) && (_e24085 > 0f)));
let _e24096 = (_e23963 << bitcast<u32>(_e23723));
let _e24108 = (_e23779 + 1i);
if _e23789 {
phi_11941_ = (_e23739.member - 1i);
} else {
phi_11941_ = _e23788;
}
let _e24112 = phi_11941_;
let _e24114 = select(_e24108, 0i, (_e24108 < 0i));
let _e24115 = (_e24114 >= _e23739.member_1);
if _e24115 {
phi_11952_ = (_e23739.member_1 - 1i);
} else {
phi_11952_ = _e24114;
}
let _e24118 = phi_11952_;
let _e24122 = (((f32(_e24112) + 0.5f) * _e23744) - 0.5f);
let _e24126 = (((f32(_e24118) + 0.5f) * _e23744) - 0.5f);
if _e487 {
phi_11980_ = type_26(_e24118, _e24112);
} else {
phi_11980_ = type_26(_e24112, _e24118);
}
let _e24132 = phi_11980_;
if _e23828 {
phi_12031_ = 0u;
} else {
if (_e23722 == 1u) {
phi_12030_ = 0u;
} else {
if (_e23722 == 2u) {
phi_12029_ = _e23821;
} else {
phi_12029_ = select(_e23827, _e23824, (_e23722 == 3u));
}
let _e24140 = phi_12029_;
phi_12030_ = _e24140;
}
let _e24142 = phi_12030_;
phi_12031_ = _e24142;
}
let _e24144 = phi_12031_;
local_190 = (((bitcast<i32>(_e24144) + _e24132.member_1) * _e23818) + _e24132.member);
let _e24149 = local_190;
let _e24151 = select(_e23845, _e24149, (_e24149 < _e23845));
let _e24156 = global_6.member[bitcast<u32>(select(0i, _e24151, (_e24151 > 0i)))];
let _e24161 = (((((select(_e24122, _e24126, _e487) + 0.5f) / _e22952) * 2f) - 1f) * _e22960);
let _e24166 = ((1f - (((select(_e24126, _e24122, _e487) + 0.5f) / _e22953) * 2f)) * _e22968);
let _e24173 = ((_e22971.member * _e24161) + (_e22979.member * _e24166));
let _e24174 = ((_e22971.member_1 * _e24161) + (_e22979.member_1 * _e24166));
let _e24175 = ((_e22971.member_2 * _e24161) + (_e22979.member_2 * _e24166));
let _e24179 = select((_e22994.member + _e24173), _e22994.member, _e22992);
let _e24180 = select((_e22994.member_1 + _e24174), _e22994.member_1, _e22992);
let _e24181 = select((_e22994.member_2 + _e24175), _e22994.member_2, _e22992);
let _e24192 = (((_e24179 * _e24179) + (_e24180 * _e24180)) + (_e24181 * _e24181));
let _e24196 = (1f / sqrt(select(0f, _e24192, (_e24192 > 0f))));
let _e24197 = (_e24179 * _e24196);
let _e24198 = (_e24180 * _e24196);
let _e24199 = (_e24181 * _e24196);
let _e24200 = (_e609 - select(_e23005.member, (_e23005.member + _e24173), _e22992));
let _e24201 = (_e621 - select(_e23005.member_1, (_e23005.member_1 + _e24174), _e22992));
let _e24202 = (_e634 - select(_e23005.member_2, (_e23005.member_2 + _e24175), _e22992));
let _e24207 = (((_e24200 * _e24197) + (_e24201 * _e24198)) + (_e24202 * _e24199));
let _e24212 = (((_e24200 * _e647) + (_e24201 * _e660)) + (_e24202 * _e673));
let _e24217 = (((_e24197 * _e647) + (_e24198 * _e660)) + (_e24199 * _e673));
let _e24220 = ((_e24198 * _e673) - (_e24199 * _e660));
let _e24223 = ((_e24199 * _e647) - (_e24197 * _e673));
let _e24226 = ((_e24197 * _e660) - (_e24198 * _e647));
let _e24231 = (((_e24220 * _e24220) + (_e24223 * _e24223)) + (_e24226 * _e24226));
let _e24234 = (1f / select(1e-9f, _e24231, (_e24231 > 1e-9f)));
let _e24237 = ((_e24207 - (_e24217 * _e24212)) * _e24234);
let _e24240 = (((_e24217 * _e24207) - _e24212) * _e24234);
let _e24246 = select(0f, _e24237, (((_e24240 >= 0f) && (_e24240 < _e725)) && (_e24237 > 0f)));
let _e24248 = (_e24112 << bitcast<u32>(_e23723));
if _e23960 {
phi_13015_ = (_e23739.member - 1i);
} else {
phi_13015_ = _e23959;
}
let _e24263 = phi_13015_;
if _e24115 {
phi_13026_ = (_e23739.member_1 - 1i);
} else {
phi_13026_ = _e24114;
}
let _e24266 = phi_13026_;
let _e24270 = (((f32(_e24263) + 0.5f) * _e23744) - 0.5f);
let _e24274 = (((f32(_e24266) + 0.5f) * _e23744) - 0.5f);
if _e487 {
phi_13054_ = type_26(_e24266, _e24263);
} else {
phi_13054_ = type_26(_e24263, _e24266);
}
let _e24280 = phi_13054_;
if _e23828 {
phi_13105_ = 0u;
} else {
if (_e23722 == 1u) {
phi_13104_ = 0u;
} else {
if (_e23722 == 2u) {
phi_13103_ = _e23821;
} else {
phi_13103_ = select(_e23827, _e23824, (_e23722 == 3u));
}
let _e24288 = phi_13103_;
phi_13104_ = _e24288;
}
let _e24290 = phi_13104_;
phi_13105_ = _e24290;
}
let _e24292 = phi_13105_;
local_188 = (((bitcast<i32>(_e24292) + _e24280.member_1) * _e23818) + _e24280.member);
let _e24297 = local_188;
let _e24299 = select(_e23845, _e24297, (_e24297 < _e23845));
let _e24304 = global_6.member[bitcast<u32>(select(0i, _e24299, (_e24299 > 0i)))];
let _e24309 = (((((select(_e24270, _e24274, _e487) + 0.5f) / _e22952) * 2f) - 1f) * _e22960);
let _e24314 = ((1f - (((select(_e24274, _e24270, _e487) + 0.5f) / _e22953) * 2f)) * _e22968);
let _e24321 = ((_e22971.member * _e24309) + (_e22979.member * _e24314));
let _e24322 = ((_e22971.member_1 * _e24309) + (_e22979.member_1 * _e24314));
let _e24323 = ((_e22971.member_2 * _e24309) + (_e22979.member_2 * _e24314));
let _e24327 = select((_e22994.member + _e24321), _e22994.member, _e22992);
let _e24328 = select((_e22994.member_1 + _e24322), _e22994.member_1, _e22992);
let _e24329 = select((_e22994.member_2 + _e24323), _e22994.member_2, _e22992);
let _e24340 = (((_e24327 * _e24327) + (_e24328 * _e24328)) + (_e24329 * _e24329));
let _e24344 = (1f / sqrt(select(0f, _e24340, (_e24340 > 0f))));
let _e24345 = (_e24327 * _e24344);
let _e24346 = (_e24328 * _e24344);
let _e24347 = (_e24329 * _e24344);
let _e24348 = (_e609 - select(_e23005.member, (_e23005.member + _e24321), _e22992));
let _e24349 = (_e621 - select(_e23005.member_1, (_e23005.member_1 + _e24322), _e22992));
let _e24350 = (_e634 - select(_e23005.member_2, (_e23005.member_2 + _e24323), _e22992));
let _e24355 = (((_e24348 * _e24345) + (_e24349 * _e24346)) + (_e24350 * _e24347));
let _e24360 = (((_e24348 * _e647) + (_e24349 * _e660)) + (_e24350 * _e673));
let _e24365 = (((_e24345 * _e647) + (_e24346 * _e660)) + (_e24347 * _e673));
let _e24368 = ((_e24346 * _e673) - (_e24347 * _e660));
let _e24371 = ((_e24347 * _e647) - (_e24345 * _e673));
let _e24374 = ((_e24345 * _e660) - (_e24346 * _e647));
let _e24379 = (((_e24368 * _e24368) + (_e24371 * _e24371)) + (_e24374 * _e24374));
let _e24382 = (1f / select(1e-9f, _e24379, (_e24379 > 1e-9f)));
let _e24385 = ((_e24355 - (_e24365 * _e24360)) * _e24382);
let _e24388 = (((_e24365 * _e24355) - _e24360) * _e24382);
let _e24394 = select(0f, _e24385, (((_e24388 >= 0f) && (_e24388 < _e725)) && (_e24385 > 0f)));
let _e24396 = (_e24263 << bitcast<u32>(_e23723));
let _e24408 = select(((((1f - select(0f, (_e23784 * _e23785), (((select(select(_e800, _e957, (_e23944 >= _e726)), _e879, (_e23944 < _e332)) == _e23722) && (_e23942 > 0f)) && (_e23942 < _e23852)))) - select(0f, (_e23781 * _e23785), (((select(select(_e800, _e957, (_e24096 >= _e726)), _e879, (_e24096 < _e332)) == _e23722) && (_e24094 > 0f)) && (_e24094 < _e24004)))) - select(0f, (_e23784 * _e23783), (((select(select(_e800, _e957, (_e24248 >= _e726)), _e879, (_e24248 < _e332)) == _e23722) && (_e24246 > 0f)) && (_e24246 < _e24156)))) - select(0f, (_e23781 * _e23783), (((select(select(_e800, _e957, (_e24396 >= _e726)), _e879, (_e24396 < _e332)) == _e23722) && (_e24394 > 0f)) && (_e24394 < _e24304)))), 1f, _e23828);
if _e487 {
phi_14098_ = type_26(_e22857, _e22765);
} else {
phi_14098_ = type_26(_e22765, _e22857);
}
let _e24423 = phi_14098_;
let _e24426 = (_e22858 && (((_e23720 > 0f) && (_e23720 < _e22948)) && (bitcast<f32>((bitcast<u32>(_e24408) & 2147483647u)) > 1e-6f)));
let _e24429 = global_1.member.member_18.member;
let _e24430 = (((select(_e22883, (1f - _e22883), (_e22868 >= 0f)) - select(_e22902, (1f - _e22902), (_e22887 >= 0f))) * (1f / _e22865)) * _e24429);
let _e24434 = select(0f, (((((_e686 * _e23707.member) * ((1f + (_e23588 * (1f + (_e23588 * (0.5f + (_e23588 * (0.16666667f + (_e23588 * (0.041666668f + (_e23588 * (0.008333334f + (_e23588 * (0.001388889f + (_e23588 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e23583 + 127i)) << bitcast<u32>(23i))))) * _e23410) * _e24408) * _e24430), _e24426);
let _e24435 = select(0f, (((((_e699 * _e23707.member_1) * ((1f + (_e23636 * (1f + (_e23636 * (0.5f + (_e23636 * (0.16666667f + (_e23636 * (0.041666668f + (_e23636 * (0.008333334f + (_e23636 * (0.001388889f + (_e23636 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e23631 + 127i)) << bitcast<u32>(23i))))) * _e23410) * _e24408) * _e24430), _e24426);
let _e24436 = select(0f, (((((_e712 * _e23707.member_2) * ((1f + (_e23684 * (1f + (_e23684 * (0.5f + (_e23684 * (0.16666667f + (_e23684 * (0.041666668f + (_e23684 * (0.008333334f + (_e23684 * (0.001388889f + (_e23684 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e23679 + 127i)) << bitcast<u32>(23i))))) * _e23410) * _e24408) * _e24430), _e24426);
let _e24440 = (bitcast<f32>((bitcast<u32>(_e24434) & 2147483647u)) >= 1073741800f);
let _e24441 = (1f / 1048576f);
let _e24444 = ((_e24434 * select(1f, _e24441, _e24440)) + 0.5f);
let _e24446 = select(-1073741800f, _e24444, (_e24444 > -1073741800f));
let _e24448 = select(1073741800f, _e24446, (_e24446 < 1073741800f));
let _e24455 = select(0i, select(select(i32(_e24448), i32(-2147483648), (_e24448 < -2147483600f)), 2147483647i, (_e24448 > 2147483500f)), (_e24448 == _e24448));
let _e24459 = (_e24455 - select(0i, 1i, (_e24448 < f32(_e24455))));
let _e24460 = select(0i, 20i, _e24440);
let _e24464 = (bitcast<u32>(_e24459) << bitcast<u32>((_e24460 & 31i)));
let _e24471 = bitcast<u32>(((_e24459 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e24460) & 31i))));
let _e24475 = (bitcast<f32>((bitcast<u32>(_e24435) & 2147483647u)) >= 1073741800f);
let _e24478 = ((_e24435 * select(1f, _e24441, _e24475)) + 0.5f);
let _e24480 = select(-1073741800f, _e24478, (_e24478 > -1073741800f));
let _e24482 = select(1073741800f, _e24480, (_e24480 < 1073741800f));
let _e24489 = select(0i, select(select(i32(_e24482), i32(-2147483648), (_e24482 < -2147483600f)), 2147483647i, (_e24482 > 2147483500f)), (_e24482 == _e24482));
let _e24493 = (_e24489 - select(0i, 1i, (_e24482 < f32(_e24489))));
let _e24494 = select(0i, 20i, _e24475);
let _e24498 = (bitcast<u32>(_e24493) << bitcast<u32>((_e24494 & 31i)));
let _e24505 = bitcast<u32>(((_e24493 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e24494) & 31i))));
let _e24509 = (bitcast<f32>((bitcast<u32>(_e24436) & 2147483647u)) >= 1073741800f);
let _e24512 = ((_e24436 * select(1f, _e24441, _e24509)) + 0.5f);
let _e24514 = select(-1073741800f, _e24512, (_e24512 > -1073741800f));
let _e24516 = select(1073741800f, _e24514, (_e24514 < 1073741800f));
let _e24523 = select(0i, select(select(i32(_e24516), i32(-2147483648), (_e24516 < -2147483600f)), 2147483647i, (_e24516 > 2147483500f)), (_e24516 == _e24516));
let _e24527 = (_e24523 - select(0i, 1i, (_e24516 < f32(_e24523))));
let _e24528 = select(0i, 20i, _e24509);
let _e24532 = (bitcast<u32>(_e24527) << bitcast<u32>((_e24528 & 31i)));
let _e24539 = bitcast<u32>(((_e24527 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e24528) & 31i))));
let _e24544 = bitcast<i32>(bitcast<u32>((((_e24423.member_1 * _e11947) + _e24423.member) * 6i)));
if ((_e24464 | _e24471) == 0u) {
} else {
let _e24547 = bitcast<u32>(_e24544);
if (_e24547 < _e304) {
let _e24551 = atomicAdd((&global_8.member[_e24547]), _e24464);
phi_14331_ = _e24551;
} else {
phi_14331_ = 0u;
}
let _e24553 = phi_14331_;
let _e24557 = (_e24471 + select(0u, 1u, ((_e24553 + _e24464) < _e24464)));
if (_e24557 == 0u) {
} else {
let _e24559 = (_e24547 + 1u);
if (_e24559 < _e304) {
let _e24563 = atomicAdd((&global_8.member[_e24559]), _e24557);
}
}
}
if ((_e24498 | _e24505) == 0u) {
} else {
let _e24567 = bitcast<u32>((_e24544 + 2i));
if (_e24567 < _e304) {
let _e24571 = atomicAdd((&global_8.member[_e24567]), _e24498);
phi_14361_ = _e24571;
} else {
phi_14361_ = 0u;
}
let _e24573 = phi_14361_;
let _e24577 = (_e24505 + select(0u, 1u, ((_e24573 + _e24498) < _e24498)));
if (_e24577 == 0u) {
} else {
let _e24579 = (_e24567 + 1u);
if (_e24579 < _e304) {
let _e24583 = atomicAdd((&global_8.member[_e24579]), _e24577);
}
}
}
if ((_e24532 | _e24539) == 0u) {
} else {
let _e24587 = bitcast<u32>((_e24544 + 4i));
if (_e24587 < _e304) {
let _e24591 = atomicAdd((&global_8.member[_e24587]), _e24532);
phi_14391_ = _e24591;
} else {
phi_14391_ = 0u;
}
let _e24593 = phi_14391_;
let _e24597 = (_e24539 + select(0u, 1u, ((_e24593 + _e24532) < _e24532)));
if (_e24597 == 0u) {
} else {
let _e24599 = (_e24587 + 1u);
if (_e24599 < _e304) {
let _e24603 = atomicAdd((&global_8.member[_e24599]), _e24597);
}
}
}
phi_8304_ = (_e22855 + 1i);
} else {
phi_8304_ = i32();
}
let _e24606 = phi_8304_;
continue;
continuing {
phi_8303_ = _e24606;
break if !(_e22858);
}
}
phi_8150_ = (_e22762 + 1i);
} else {
phi_8150_ = i32();
}
let _e24610 = phi_8150_;
continue;
continuing {
phi_8149_ = _e24610;
break if !(_e22763);
}
}
} else {
phi_14436_ = 0i;
loop {
let _e19572 = phi_14436_;
let _e19573 = (_e19572 < 16i);
if _e19573 {
let _e19575 = (_e11992 + (_e19572 & 15i));
let _e19577 = (f32(_e19575) + 0.5f);
let _e19579 = ((_e19577 * 1f) - 0.5f);
let _e19583 = (-(((_e450 * _e19579) + _e476)) / _e463);
let _e19590 = bitcast<f32>((bitcast<u32>(((_e500 * _e19579) + ((_e513 * _e19583) + _e526))) & 2147483647u));
let _e19597 = bitcast<f32>((bitcast<u32>(((_e539 * _e19579) + ((_e552 * _e19583) + _e565))) & 2147483647u));
let _e19601 = (((0.5f * (_e19590 + _e19597)) / _e568) + _e751);
let _e19602 = (1f / 1f);
let _e19610 = ((((_e19583 + _e19601) + 0.5f) * _e19602) - 0.5f);
let _e19611 = f32(_e11997);
let _e19612 = (0f - 1f);
let _e19614 = select(_e19612, _e19610, (_e19610 > _e19612));
let _e19616 = select(_e19611, _e19614, (_e19614 < _e19611));
let _e19623 = select(0i, select(select(i32(_e19616), i32(-2147483648), (_e19616 < -2147483600f)), 2147483647i, (_e19616 > 2147483500f)), (_e19616 == _e19616));
let _e19628 = (((((_e19583 - _e19601) + 0.5f) * _e19602) - 0.5f) + 1f);
let _e19629 = (_e19611 + 1f);
let _e19631 = select(0f, _e19628, (_e19628 > 0f));
let _e19633 = select(_e19629, _e19631, (_e19631 < _e19629));
let _e19640 = select(0i, select(select(i32(_e19633), i32(-2147483648), (_e19633 < -2147483600f)), 2147483647i, (_e19633 > 2147483500f)), (_e19633 == _e19633));
let _e19651 = ((1e-4f * 1f) * _e568);
let _e19653 = select(_e19597, _e19590, (_e19590 > _e19597));
let _e19655 = select(_e19651, _e19653, (_e19653 > _e19651));
let _e19657 = select(_e19597, _e19590, (_e19590 < _e19597));
let _e19659 = select(_e19651, _e19657, (_e19657 > _e19651));
let _e19661 = (0.5f * (_e19655 + _e19659));
let _e19662 = (0.5f / _e19659);
let _e19663 = (1f / _e19655);
phi_14590_ = 0i;
loop {
let _e19665 = phi_14590_;
let _e19667 = (((_e19640 - select(0i, 1i, (_e19633 < f32(_e19640)))) + (_e19572 >> bitcast<u32>(4u))) + bitcast<i32>(_e19665));
let _e19668 = (_e19667 <= select(-1i, (_e19623 - select(0i, 1i, (_e19616 < f32(_e19623)))), (_e19575 <= _e11996)));
if _e19668 {
let _e19670 = (f32(_e19667) + 0.5f);
let _e19674 = ((((_e19670 * 1f) - 0.5f) - _e19583) * _e568);
let _e19675 = (_e568 * 1f);
let _e19677 = (0.5f * _e19675);
let _e19678 = (_e19674 + _e19677);
let _e19679 = -(_e19678);
let _e19682 = (_e19661 - select(_e19679, _e19678, (_e19678 > _e19679)));
let _e19684 = select(0f, _e19682, (_e19682 > 0f));
let _e19686 = select(_e19659, _e19684, (_e19684 < _e19659));
let _e19689 = (_e19682 - _e19659);
let _e19693 = (((_e19686 * (_e19686 * _e19662)) + select(0f, _e19689, (_e19689 > 0f))) * _e19663);
let _e19697 = (_e19674 - _e19677);
let _e19698 = -(_e19697);
let _e19701 = (_e19661 - select(_e19698, _e19697, (_e19697 > _e19698)));
let _e19703 = select(0f, _e19701, (_e19701 > 0f));
let _e19705 = select(_e19659, _e19703, (_e19703 < _e19659));
let _e19708 = (_e19701 - _e19659);
let _e19712 = (((_e19705 * (_e19705 * _e19662)) + select(0f, _e19708, (_e19708 > 0f))) * _e19663);
if _e487 {
phi_14695_ = type_26(_e19667, _e19575);
} else {
phi_14695_ = type_26(_e19575, _e19667);
}
let _e19721 = phi_14695_;
let _e19725 = bitcast<i32>((_e11943 * _e11946));
local_186 = _e19725;
local_187 = ((_e19721.member_1 * _e11947) + _e19721.member);
let _e19728 = local_186;
let _e19729 = local_187;
let _e19730 = (_e19728 + _e19729);
let _e19732 = (bitcast<i32>(_e293) - 1i);
let _e19734 = select(_e19732, _e19730, (_e19730 < _e19732));
let _e19739 = global_5.member[bitcast<u32>(select(0i, _e19734, (_e19734 > 0i)))];
let _e19740 = local_186;
let _e19742 = local_187;
let _e19743 = ((2i * _e19740) + _e19742);
let _e19745 = select(_e19732, _e19743, (_e19743 < _e19732));
let _e19750 = global_5.member[bitcast<u32>(select(0i, _e19745, (_e19745 > 0i)))];
let _e19751 = local_187;
let _e19753 = select(_e19732, _e19751, (_e19751 < _e19732));
let _e19758 = global_5.member[bitcast<u32>(select(0i, _e19753, (_e19753 > 0i)))];
let _e19759 = local_187;
let _e19762 = f32(_e11947);
let _e19763 = f32(_e11948);
let _e19770 = global_1.member.member_2.member;
let _e19771 = (((((f32(_e19721.member) + 0.5f) / _e19762) * 2f) - 1f) * _e19770);
let _e19778 = global_1.member.member_2.member_1;
let _e19779 = ((1f - (((f32(_e19721.member_1) + 0.5f) / _e19763) * 2f)) * _e19778);
let _e19781 = global_1.member.member_3;
let _e19789 = global_1.member.member_4;
let _e19796 = ((_e19781.member * _e19771) + (_e19789.member * _e19779));
let _e19797 = ((_e19781.member_1 * _e19771) + (_e19789.member_1 * _e19779));
let _e19798 = ((_e19781.member_2 * _e19771) + (_e19789.member_2 * _e19779));
let _e19801 = global_1.member.member_2.member_3;
let _e19802 = (_e19801 != 0u);
let _e19804 = global_1.member.member_5;
let _e19811 = select((_e19804.member + _e19796), _e19804.member, _e19802);
let _e19812 = select((_e19804.member_1 + _e19797), _e19804.member_1, _e19802);
let _e19813 = select((_e19804.member_2 + _e19798), _e19804.member_2, _e19802);
let _e19815 = global_1.member.member_6;
let _e19822 = select(_e19815.member, (_e19815.member + _e19796), _e19802);
let _e19823 = select(_e19815.member_1, (_e19815.member_1 + _e19797), _e19802);
let _e19824 = select(_e19815.member_2, (_e19815.member_2 + _e19798), _e19802);
let _e19829 = (((_e19811 * _e19811) + (_e19812 * _e19812)) + (_e19813 * _e19813));
let _e19832 = sqrt(select(0f, _e19829, (_e19829 > 0f)));
let _e19833 = (1f / _e19832);
let _e19834 = (_e19811 * _e19833);
let _e19835 = (_e19812 * _e19833);
let _e19836 = (_e19813 * _e19833);
let _e19837 = (_e609 - _e19822);
let _e19838 = (_e621 - _e19823);
let _e19839 = (_e634 - _e19824);
let _e19844 = (((_e19837 * _e19834) + (_e19838 * _e19835)) + (_e19839 * _e19836));
let _e19849 = (((_e19837 * _e647) + (_e19838 * _e660)) + (_e19839 * _e673));
let _e19854 = (((_e19834 * _e647) + (_e19835 * _e660)) + (_e19836 * _e673));
let _e19857 = ((_e19835 * _e673) - (_e19836 * _e660));
let _e19860 = ((_e19836 * _e647) - (_e19834 * _e673));
let _e19863 = ((_e19834 * _e660) - (_e19835 * _e647));
let _e19868 = (((_e19857 * _e19857) + (_e19860 * _e19860)) + (_e19863 * _e19863));
let _e19871 = (1f / select(1e-9f, _e19868, (_e19868 > 1e-9f)));
let _e19874 = ((_e19844 - (_e19854 * _e19849)) * _e19871);
let _e19877 = (((_e19854 * _e19844) - _e19849) * _e19871);
let _e19883 = -(_e19854);
let _e19886 = global_1.member.member_13.member_2;
let _e19887 = (_e19886 * _e19886);
let _e19891 = ((1f + _e19887) - ((2f * _e19886) * _e19883));
let _e19893 = select(1e-9f, _e19891, (_e19891 > 1e-9f));
let _e19905 = global_1.member.member_13.member_3;
if (_e19905 == 2u) {
let _e19910 = (0.5f - (0.5f * _e19883));
let _e19912 = select(0f, _e19910, (_e19910 > 0f));
let _e19916 = (sqrt(select(0f, _e19912, (_e19912 > 0f))) * 255f);
let _e19917 = (255f - 1f);
let _e19919 = select(0f, _e19916, (_e19916 > 0f));
let _e19921 = select(_e19917, _e19919, (_e19919 < _e19917));
let _e19928 = select(0i, select(select(i32(_e19921), i32(-2147483648), (_e19921 < -2147483600f)), 2147483647i, (_e19921 > 2147483500f)), (_e19921 == _e19921));
let _e19932 = (_e19928 - select(0i, 1i, (_e19921 < f32(_e19928))));
let _e19935 = global_1.member.member_13.member_11;
let _e19936 = bitcast<i32>(_e19935);
let _e19937 = (_e19936 + _e19932);
let _e19939 = (bitcast<i32>(_e299) - 1i);
let _e19941 = select(_e19939, _e19937, (_e19937 < _e19939));
let _e19946 = global_2.member[bitcast<u32>(select(0i, _e19941, (_e19941 > 0i)))];
let _e19948 = (_e19936 + (_e19932 + 1i));
let _e19950 = select(_e19939, _e19948, (_e19948 < _e19939));
let _e19955 = global_2.member[bitcast<u32>(select(0i, _e19950, (_e19950 > 0i)))];
phi_15122_ = (_e19946 + ((_e19955 - _e19946) * (_e19916 - f32(_e19932))));
} else {
phi_15122_ = select(((1f - _e19887) / (_e19893 * sqrt(select(0f, _e19893, (_e19893 > 0f))))), (0.75f * (1f + (_e19883 * _e19883))), (_e19905 == 1u));
}
let _e19962 = phi_15122_;
let _e19974 = global_1.member.member_13.member_7;
let _e19975 = bitcast<i32>(_e19974);
let _e19978 = global_1.member.member_13.member_8;
let _e19979 = bitcast<i32>(_e19978);
let _e19982 = global_1.member.member_13.member_9;
let _e19983 = bitcast<i32>(_e19982);
let _e19986 = global_1.member.member_13.member_4;
let _e19992 = global_1.member.member_13.member_5;
let _e19996 = f32(_e19975);
let _e20001 = (((((_e19822 + (_e19834 * _e19874)) - _e19986.member) / (_e19992.member - _e19986.member)) * _e19996) - 0.5f);
let _e20002 = (_e19996 - 1f);
let _e20004 = select(0f, _e20001, (_e20001 > 0f));
let _e20006 = select(_e20002, _e20004, (_e20004 < _e20002));
let _e20007 = f32(_e19979);
let _e20012 = (((((_e19823 + (_e19835 * _e19874)) - _e19986.member_1) / (_e19992.member_1 - _e19986.member_1)) * _e20007) - 0.5f);
let _e20013 = (_e20007 - 1f);
let _e20015 = select(0f, _e20012, (_e20012 > 0f));
let _e20017 = select(_e20013, _e20015, (_e20015 < _e20013));
let _e20018 = f32(_e19983);
let _e20023 = (((((_e19824 + (_e19836 * _e19874)) - _e19986.member_2) / (_e19992.member_2 - _e19986.member_2)) * _e20018) - 0.5f);
let _e20024 = (_e20018 - 1f);
let _e20026 = select(0f, _e20023, (_e20023 > 0f));
let _e20028 = select(_e20024, _e20026, (_e20026 < _e20024));
let _e20030 = select(0f, _e20006, (_e20006 > 0f));
let _e20032 = select(1e6f, _e20030, (_e20030 < 1e6f));
let _e20039 = select(0i, select(select(i32(_e20032), i32(-2147483648), (_e20032 < -2147483600f)), 2147483647i, (_e20032 > 2147483500f)), (_e20032 == _e20032));
let _e20043 = (_e20039 - select(0i, 1i, (_e20032 < f32(_e20039))));
let _e20045 = select(0f, _e20017, (_e20017 > 0f));
let _e20047 = select(1e6f, _e20045, (_e20045 < 1e6f));
let _e20054 = select(0i, select(select(i32(_e20047), i32(-2147483648), (_e20047 < -2147483600f)), 2147483647i, (_e20047 > 2147483500f)), (_e20047 == _e20047));
let _e20058 = (_e20054 - select(0i, 1i, (_e20047 < f32(_e20054))));
let _e20060 = select(0f, _e20028, (_e20028 > 0f));
let _e20062 = select(1e6f, _e20060, (_e20060 < 1e6f));
let _e20069 = select(0i, select(select(i32(_e20062), i32(-2147483648), (_e20062 < -2147483600f)), 2147483647i, (_e20062 > 2147483500f)), (_e20062 == _e20062));
let _e20073 = (_e20069 - select(0i, 1i, (_e20062 < f32(_e20069))));
let _e20077 = (_e20017 - f32(_e20058));
let _e20079 = (_e20028 - f32(_e20073));
local_184 = (_e20006 - f32(_e20043));
let _e20080 = (_e20043 + 1i);
let _e20082 = select(_e20080, 0i, (_e20080 < 0i));
if (_e20082 >= _e19975) {
phi_15254_ = (_e19975 - 1i);
} else {
phi_15254_ = _e20082;
}
let _e20086 = phi_15254_;
local_185 = (_e20086 - _e20043);
let _e20088 = (_e20058 + 1i);
let _e20090 = select(_e20088, 0i, (_e20088 < 0i));
if (_e20090 >= _e19979) {
phi_15267_ = (_e19979 - 1i);
} else {
phi_15267_ = _e20090;
}
let _e20094 = phi_15267_;
let _e20096 = ((_e20094 - _e20058) * _e19975);
let _e20097 = (_e20073 + 1i);
let _e20099 = select(_e20097, 0i, (_e20097 < 0i));
if (_e20099 >= _e19983) {
phi_15281_ = (_e19983 - 1i);
} else {
phi_15281_ = _e20099;
}
let _e20103 = phi_15281_;
let _e20109 = global_1.member.member_13.member_10;
let _e20115 = ((bitcast<i32>(_e20109) + (((_e20073 * _e19979) + _e20058) * _e19975)) + _e20043);
let _e20117 = (bitcast<i32>(_e299) - 1i);
let _e20119 = select(_e20117, _e20115, (_e20115 < _e20117));
let _e20124 = global_2.member[bitcast<u32>(select(0i, _e20119, (_e20119 > 0i)))];
let _e20125 = local_184;
let _e20128 = local_185;
let _e20129 = (_e20115 + _e20128);
let _e20131 = select(_e20117, _e20129, (_e20129 < _e20117));
let _e20136 = global_2.member[bitcast<u32>(select(0i, _e20131, (_e20131 > 0i)))];
let _e20137 = local_184;
let _e20140 = (1f - _e20077);
let _e20142 = (_e20115 + _e20096);
let _e20144 = select(_e20117, _e20142, (_e20142 < _e20117));
let _e20149 = global_2.member[bitcast<u32>(select(0i, _e20144, (_e20144 > 0i)))];
let _e20150 = local_184;
let _e20153 = local_185;
let _e20154 = (_e20142 + _e20153);
let _e20156 = select(_e20117, _e20154, (_e20154 < _e20117));
let _e20161 = global_2.member[bitcast<u32>(select(0i, _e20156, (_e20156 > 0i)))];
let _e20162 = local_184;
let _e20167 = (_e20115 + (((_e20103 - _e20073) * _e19975) * _e19979));
let _e20169 = select(_e20117, _e20167, (_e20167 < _e20117));
let _e20174 = global_2.member[bitcast<u32>(select(0i, _e20169, (_e20169 > 0i)))];
let _e20175 = local_184;
let _e20178 = local_185;
let _e20179 = (_e20167 + _e20178);
let _e20181 = select(_e20117, _e20179, (_e20179 < _e20117));
let _e20186 = global_2.member[bitcast<u32>(select(0i, _e20181, (_e20181 > 0i)))];
let _e20187 = local_184;
let _e20191 = (_e20167 + _e20096);
let _e20193 = select(_e20117, _e20191, (_e20191 < _e20117));
let _e20198 = global_2.member[bitcast<u32>(select(0i, _e20193, (_e20193 > 0i)))];
let _e20199 = local_184;
let _e20202 = local_185;
let _e20203 = (_e20191 + _e20202);
let _e20205 = select(_e20117, _e20203, (_e20203 < _e20117));
let _e20210 = global_2.member[bitcast<u32>(select(0i, _e20205, (_e20205 > 0i)))];
let _e20211 = local_184;
let _e20220 = ((_e19832 * (_e19962 * (0.25f / 3.1415927f))) * ((((((_e20124 * (1f - _e20125)) + (_e20136 * _e20137)) * _e20140) + (((_e20149 * (1f - _e20150)) + (_e20161 * _e20162)) * _e20077)) * (1f - _e20079)) + (((((_e20174 * (1f - _e20175)) + (_e20186 * _e20187)) * _e20140) + (((_e20198 * (1f - _e20199)) + (_e20210 * _e20211)) * _e20077)) * _e20079)));
let _e20223 = global_1.member.member_12.member_12;
let _e20226 = global_1.member.member_12.member_4;
let _e20229 = global_1.member.member_12.member_13;
let _e20235 = global_1.member.member.member;
let _e20237 = (_e19877 / _e725);
local_181 = bitcast<i32>((_e20223 + (_e20226 * _e20229)));
local_182 = _e315;
local_183 = bitcast<i32>(_e20235);
let _e20240 = global_1.member.member_13.member_6;
let _e20241 = f32(_e20240);
let _e20243 = select(0f, _e20237, (_e20237 > 0f));
let _e20246 = (select(1f, _e20243, (_e20243 < 1f)) * _e20241);
let _e20247 = (_e20241 - 1f);
let _e20249 = select(0f, _e20247, (_e20247 > 0f));
let _e20251 = select(0f, _e20246, (_e20246 > 0f));
let _e20253 = select(_e20249, _e20251, (_e20251 < _e20249));
let _e20260 = select(0i, select(select(i32(_e20253), i32(-2147483648), (_e20253 < -2147483600f)), 2147483647i, (_e20253 > 2147483500f)), (_e20253 == _e20253));
let _e20264 = (_e20260 - select(0i, 1i, (_e20253 < f32(_e20260))));
if (_e20264 > 0i) {
let _e20267 = local_181;
let _e20268 = local_183;
let _e20271 = local_182;
let _e20272 = ((_e20267 + ((_e20264 - 1i) * _e20268)) + _e20271);
let _e20274 = (bitcast<i32>(_e302) - 1i);
let _e20276 = select(_e20274, _e20272, (_e20272 < _e20274));
let _e20281 = global_7.member[bitcast<u32>(select(0i, _e20276, (_e20276 > 0i)))];
phi_15585_ = _e20281;
} else {
phi_15585_ = 0f;
}
let _e20283 = phi_15585_;
let _e20284 = local_181;
let _e20285 = local_183;
let _e20288 = local_182;
let _e20289 = ((_e20284 + (_e20264 * _e20285)) + _e20288);
let _e20291 = (bitcast<i32>(_e302) - 1i);
let _e20293 = select(_e20291, _e20289, (_e20289 < _e20291));
let _e20298 = global_7.member[bitcast<u32>(select(0i, _e20293, (_e20293 > 0i)))];
let _e20305 = (_e19750 - _e19739);
let _e20308 = ((_e19874 - _e19739) / select(1e-9f, _e20305, (_e20305 > 1e-9f)));
local_178 = 0i;
local_179 = _e19759;
local_180 = _e19725;
let _e20310 = select(0f, _e20308, (_e20308 > 0f));
let _e20313 = (select(1f, _e20310, (_e20310 < 1f)) * _e20241);
let _e20315 = select(0f, _e20313, (_e20313 > 0f));
let _e20317 = select(_e20249, _e20315, (_e20315 < _e20249));
let _e20324 = select(0i, select(select(i32(_e20317), i32(-2147483648), (_e20317 < -2147483600f)), 2147483647i, (_e20317 > 2147483500f)), (_e20317 == _e20317));
let _e20328 = (_e20324 - select(0i, 1i, (_e20317 < f32(_e20324))));
if (_e20328 > 0i) {
let _e20331 = local_178;
let _e20332 = local_180;
let _e20335 = local_179;
let _e20336 = ((_e20331 + ((_e20328 - 1i) * _e20332)) + _e20335);
let _e20338 = select(_e20291, _e20336, (_e20336 < _e20291));
let _e20343 = global_7.member[bitcast<u32>(select(0i, _e20338, (_e20338 > 0i)))];
phi_15712_ = _e20343;
} else {
phi_15712_ = 0f;
}
let _e20345 = phi_15712_;
let _e20346 = local_178;
let _e20347 = local_180;
let _e20350 = local_179;
let _e20351 = ((_e20346 + (_e20328 * _e20347)) + _e20350);
let _e20353 = select(_e20291, _e20351, (_e20351 < _e20291));
let _e20358 = global_7.member[bitcast<u32>(select(0i, _e20353, (_e20353 > 0i)))];
let _e20364 = ((_e20283 + ((_e20298 - _e20283) * (_e20246 - f32(_e20264)))) + (_e20345 + ((_e20358 - _e20345) * (_e20313 - f32(_e20328)))));
let _e20367 = global_1.member.member_13.member;
let _e20372 = -((_e20367.member * _e20364));
let _e20374 = select(-87f, _e20372, (_e20372 > -87f));
let _e20376 = select(88f, _e20374, (_e20374 < 88f));
let _e20378 = ((_e20376 * 1.442695f) + 0.5f);
let _e20380 = select(-127f, _e20378, (_e20378 > -127f));
let _e20382 = select(128f, _e20380, (_e20380 < 128f));
let _e20389 = select(0i, select(select(i32(_e20382), i32(-2147483648), (_e20382 < -2147483600f)), 2147483647i, (_e20382 > 2147483500f)), (_e20382 == _e20382));
let _e20393 = (_e20389 - select(0i, 1i, (_e20382 < f32(_e20389))));
let _e20394 = f32(_e20393);
let _e20398 = ((_e20376 - (_e20394 * 0.6933594f)) - (_e20394 * -2.1219444e-4f));
let _e20420 = -((_e20367.member_1 * _e20364));
let _e20422 = select(-87f, _e20420, (_e20420 > -87f));
let _e20424 = select(88f, _e20422, (_e20422 < 88f));
let _e20426 = ((_e20424 * 1.442695f) + 0.5f);
let _e20428 = select(-127f, _e20426, (_e20426 > -127f));
let _e20430 = select(128f, _e20428, (_e20428 < 128f));
let _e20437 = select(0i, select(select(i32(_e20430), i32(-2147483648), (_e20430 < -2147483600f)), 2147483647i, (_e20430 > 2147483500f)), (_e20430 == _e20430));
let _e20441 = (_e20437 - select(0i, 1i, (_e20430 < f32(_e20437))));
let _e20442 = f32(_e20441);
let _e20446 = ((_e20424 - (_e20442 * 0.6933594f)) - (_e20442 * -2.1219444e-4f));
let _e20468 = -((_e20367.member_2 * _e20364));
let _e20470 = select(-87f, _e20468, (_e20468 > -87f));
let _e20472 = select(88f, _e20470, (_e20470 < 88f));
let _e20474 = ((_e20472 * 1.442695f) + 0.5f);
let _e20476 = select(-127f, _e20474, (_e20474 > -127f));
let _e20478 = select(128f, _e20476, (_e20476 < 128f));
let _e20485 = select(0i, select(select(i32(_e20478), i32(-2147483648), (_e20478 < -2147483600f)), 2147483647i, (_e20478 > 2147483500f)), (_e20478 == _e20478));
let _e20489 = (_e20485 - select(0i, 1i, (_e20478 < f32(_e20485))));
let _e20490 = f32(_e20489);
let _e20494 = ((_e20472 - (_e20490 * 0.6933594f)) - (_e20490 * -2.1219444e-4f));
let _e20517 = global_1.member.member_13.member_1;
let _e20530 = select(0f, _e19874, (((_e19877 >= 0f) && (_e19877 < _e725)) && (_e19874 > 0f)));
let _e20531 = (_e800 & 31u);
let _e20533 = (1u << bitcast<u32>(_e20531));
let _e20542 = bitcast<i32>((((_e11943 + _e20533) - 1u) >> bitcast<u32>(_e20531)));
let _e20543 = bitcast<i32>((((_e11946 + _e20533) - 1u) >> bitcast<u32>(_e20531)));
if _e487 {
phi_16000_ = type_26(_e20543, _e20542);
} else {
phi_16000_ = type_26(_e20542, _e20543);
}
let _e20547 = phi_16000_;
let _e20552 = f32((1i << bitcast<u32>(_e20531)));
let _e20553 = (1f / _e20552);
let _e20555 = ((_e19577 * _e20553) - 0.5f);
let _e20557 = ((_e19670 * _e20553) - 0.5f);
let _e20559 = select(-1f, _e20555, (_e20555 > -1f));
let _e20561 = select(1e6f, _e20559, (_e20559 < 1e6f));
let _e20568 = select(0i, select(select(i32(_e20561), i32(-2147483648), (_e20561 < -2147483600f)), 2147483647i, (_e20561 > 2147483500f)), (_e20561 == _e20561));
let _e20572 = (_e20568 - select(0i, 1i, (_e20561 < f32(_e20568))));
let _e20574 = select(-1f, _e20557, (_e20557 > -1f));
let _e20576 = select(1e6f, _e20574, (_e20574 < 1e6f));
let _e20583 = select(0i, select(select(i32(_e20576), i32(-2147483648), (_e20576 < -2147483600f)), 2147483647i, (_e20576 > 2147483500f)), (_e20576 == _e20576));
let _e20587 = (_e20583 - select(0i, 1i, (_e20576 < f32(_e20583))));
let _e20589 = (_e20555 - f32(_e20572));
let _e20591 = (_e20557 - f32(_e20587));
let _e20592 = (1f - _e20589);
let _e20593 = (1f - _e20591);
let _e20596 = select(_e20572, 0i, (_e20572 < 0i));
let _e20597 = (_e20596 >= _e20547.member);
if _e20597 {
phi_16078_ = (_e20547.member - 1i);
} else {
phi_16078_ = _e20596;
}
let _e20600 = phi_16078_;
let _e20602 = select(_e20587, 0i, (_e20587 < 0i));
let _e20603 = (_e20602 >= _e20547.member_1);
if _e20603 {
phi_16089_ = (_e20547.member_1 - 1i);
} else {
phi_16089_ = _e20602;
}
let _e20606 = phi_16089_;
let _e20610 = (((f32(_e20600) + 0.5f) * _e20552) - 0.5f);
let _e20614 = (((f32(_e20606) + 0.5f) * _e20552) - 0.5f);
if _e487 {
phi_16117_ = type_26(_e20606, _e20600);
} else {
phi_16117_ = type_26(_e20600, _e20606);
}
let _e20620 = phi_16117_;
let _e20626 = bitcast<i32>(((_e11943 + 1u) >> bitcast<u32>(1u)));
let _e20629 = global_1.member.member_18.member_6;
let _e20632 = global_1.member.member_18.member_7;
let _e20635 = global_1.member.member_18.member_8;
if _e11998 {
phi_16168_ = 0u;
} else {
if (_e800 == 1u) {
phi_16167_ = 0u;
} else {
if (_e800 == 2u) {
phi_16166_ = _e20629;
} else {
phi_16166_ = select(_e20635, _e20632, (_e800 == 3u));
}
let _e20641 = phi_16166_;
phi_16167_ = _e20641;
}
let _e20643 = phi_16167_;
phi_16168_ = _e20643;
}
let _e20645 = phi_16168_;
local_176 = (((bitcast<i32>(_e20645) + _e20620.member_1) * _e20626) + _e20620.member);
let _e20650 = local_176;
let _e20652 = (bitcast<i32>(_e296) - 1i);
let _e20654 = select(_e20652, _e20650, (_e20650 < _e20652));
let _e20659 = global_6.member[bitcast<u32>(select(0i, _e20654, (_e20654 > 0i)))];
let _e20664 = (((((select(_e20610, _e20614, _e487) + 0.5f) / _e19762) * 2f) - 1f) * _e19770);
let _e20669 = ((1f - (((select(_e20614, _e20610, _e487) + 0.5f) / _e19763) * 2f)) * _e19778);
let _e20676 = ((_e19781.member * _e20664) + (_e19789.member * _e20669));
let _e20677 = ((_e19781.member_1 * _e20664) + (_e19789.member_1 * _e20669));
let _e20678 = ((_e19781.member_2 * _e20664) + (_e19789.member_2 * _e20669));
let _e20682 = select((_e19804.member + _e20676), _e19804.member, _e19802);
let _e20683 = select((_e19804.member_1 + _e20677), _e19804.member_1, _e19802);
let _e20684 = select((_e19804.member_2 + _e20678), _e19804.member_2, _e19802);
let _e20695 = (((_e20682 * _e20682) + (_e20683 * _e20683)) + (_e20684 * _e20684));
let _e20699 = (1f / sqrt(select(0f, _e20695, (_e20695 > 0f))));
let _e20700 = (_e20682 * _e20699);
let _e20701 = (_e20683 * _e20699);
let _e20702 = (_e20684 * _e20699);
let _e20703 = (_e609 - select(_e19815.member, (_e19815.member + _e20676), _e19802));
let _e20704 = (_e621 - select(_e19815.member_1, (_e19815.member_1 + _e20677), _e19802));
let _e20705 = (_e634 - select(_e19815.member_2, (_e19815.member_2 + _e20678), _e19802));
let _e20710 = (((_e20703 * _e20700) + (_e20704 * _e20701)) + (_e20705 * _e20702));
let _e20715 = (((_e20703 * _e647) + (_e20704 * _e660)) + (_e20705 * _e673));
let _e20720 = (((_e20700 * _e647) + (_e20701 * _e660)) + (_e20702 * _e673));
let _e20723 = ((_e20701 * _e673) - (_e20702 * _e660));
let _e20726 = ((_e20702 * _e647) - (_e20700 * _e673));
let _e20729 = ((_e20700 * _e660) - (_e20701 * _e647));
let _e20734 = (((_e20723 * _e20723) + (_e20726 * _e20726)) + (_e20729 * _e20729));
let _e20737 = (1f / select(1e-9f, _e20734, (_e20734 > 1e-9f)));
let _e20740 = ((_e20710 - (_e20720 * _e20715)) * _e20737);
let _e20743 = (((_e20720 * _e20710) - _e20715) * _e20737);
let _e20749 = select(0f, _e20740, (((_e20743 >= 0f) && (_e20743 < _e725)) && (_e20740 > 0f)));
let _e20751 = (_e20600 << bitcast<u32>(_e20531));
let _e20763 = (_e20572 + 1i);
let _e20766 = select(_e20763, 0i, (_e20763 < 0i));
let _e20767 = (_e20766 >= _e20547.member);
if _e20767 {
phi_17152_ = (_e20547.member - 1i);
} else {
phi_17152_ = _e20766;
}
let _e20770 = phi_17152_;
if _e20603 {
phi_17163_ = (_e20547.member_1 - 1i);
} else {
phi_17163_ = _e20602;
}
let _e20773 = phi_17163_;
let _e20777 = (((f32(_e20770) + 0.5f) * _e20552) - 0.5f);
let _e20781 = (((f32(_e20773) + 0.5f) * _e20552) - 0.5f);
if _e487 {
phi_17191_ = type_26(_e20773, _e20770);
} else {
phi_17191_ = type_26(_e20770, _e20773);
}
let _e20787 = phi_17191_;
if _e11998 {
phi_17242_ = 0u;
} else {
if (_e800 == 1u) {
phi_17241_ = 0u;
} else {
if (_e800 == 2u) {
phi_17240_ = _e20629;
} else {
phi_17240_ = select(_e20635, _e20632, (_e800 == 3u));
}
let _e20795 = phi_17240_;
phi_17241_ = _e20795;
}
let _e20797 = phi_17241_;
phi_17242_ = _e20797;
}
let _e20799 = phi_17242_;
local_174 = (((bitcast<i32>(_e20799) + _e20787.member_1) * _e20626) + _e20787.member);
let _e20804 = local_174;
let _e20806 = select(_e20652, _e20804, (_e20804 < _e20652));
let _e20811 = global_6.member[bitcast<u32>(select(0i, _e20806, (_e20806 > 0i)))];
let _e20816 = (((((select(_e20777, _e20781, _e487) + 0.5f) / _e19762) * 2f) - 1f) * _e19770);
let _e20821 = ((1f - (((select(_e20781, _e20777, _e487) + 0.5f) / _e19763) * 2f)) * _e19778);
let _e20828 = ((_e19781.member * _e20816) + (_e19789.member * _e20821));
let _e20829 = ((_e19781.member_1 * _e20816) + (_e19789.member_1 * _e20821));
let _e20830 = ((_e19781.member_2 * _e20816) + (_e19789.member_2 * _e20821));
let _e20834 = select((_e19804.member + _e20828), _e19804.member, _e19802);
let _e20835 = select((_e19804.member_1 + _e20829), _e19804.member_1, _e19802);
let _e20836 = select((_e19804.member_2 + _e20830), _e19804.member_2, _e19802);
let _e20847 = (((_e20834 * _e20834) + (_e20835 * _e20835)) + (_e20836 * _e20836));
let _e20851 = (1f / sqrt(select(0f, _e20847, (_e20847 > 0f))));
let _e20852 = (_e20834 * _e20851);
let _e20853 = (_e20835 * _e20851);
let _e20854 = (_e20836 * _e20851);
let _e20855 = (_e609 - select(_e19815.member, (_e19815.member + _e20828), _e19802));
let _e20856 = (_e621 - select(_e19815.member_1, (_e19815.member_1 + _e20829), _e19802));
let _e20857 = (_e634 - select(_e19815.member_2, (_e19815.member_2 + _e20830), _e19802));
let _e20862 = (((_e20855 * _e20852) + (_e20856 * _e20853)) + (_e20857 * _e20854));
let _e20867 = (((_e20855 * _e647) + (_e20856 * _e660)) + (_e20857 * _e673));
let _e20872 = (((_e20852 * _e647) + (_e20853 * _e660)) + (_e20854 * _e673));
let _e20875 = ((_e20853 * _e673) - (_e20854 * _e660));
let _e20878 = ((_e20854 * _e647) - (_e20852 * _e673));
let _e20881 = ((_e20852 * _e660) - (_e20853 * _e647));
let _e20886 = (((_e20875 * _e20875) + (_e20878 * _e20878)) + (_e20881 * _e20881));
let _e20889 = (1f / select(1e-9f, _e20886, (_e20886 > 1e-9f)));
let _e20892 = ((_e20862 - (_e20872 * _e20867)) * _e20889);
let _e20895 = (((_e20872 * _e20862) - _e20867) * _e20889);
let _e20901 = select(0f, _e20892, (((_e20895 >= 0f) && (_e20895 < _e725)) && (_e20892 > 0f)));
let _e20903 = (_e20770 << bitcast<u32>(_e20531));
let _e20915 = (_e20587 + 1i);
if _e20597 {
phi_18226_ = (_e20547.member - 1i);
} else {
phi_18226_ = _e20596;
}
let _e20919 = phi_18226_;
let _e20921 = select(_e20915, 0i, (_e20915 < 0i));
let _e20922 = (_e20921 >= _e20547.member_1);
if _e20922 {
phi_18237_ = (_e20547.member_1 - 1i);
} else {
phi_18237_ = _e20921;
}
let _e20925 = phi_18237_;
let _e20929 = (((f32(_e20919) + 0.5f) * _e20552) - 0.5f);
let _e20933 = (((f32(_e20925) + 0.5f) * _e20552) - 0.5f);
if _e487 {
phi_18265_ = type_26(_e20925, _e20919);
} else {
phi_18265_ = type_26(_e20919, _e20925);
}
let _e20939 = phi_18265_;
if _e11998 {
phi_18316_ = 0u;
} else {
if (_e800 == 1u) {
phi_18315_ = 0u;
} else {
if (_e800 == 2u) {
phi_18314_ = _e20629;
} else {
phi_18314_ = select(_e20635, _e20632, (_e800 == 3u));
}
let _e20947 = phi_18314_;
phi_18315_ = _e20947;
}
let _e20949 = phi_18315_;
phi_18316_ = _e20949;
}
let _e20951 = phi_18316_;
local_172 = (((bitcast<i32>(_e20951) + _e20939.member_1) * _e20626) + _e20939.member);
let _e20956 = local_172;
let _e20958 = select(_e20652, _e20956, (_e20956 < _e20652));
let _e20963 = global_6.member[bitcast<u32>(select(0i, _e20958, (_e20958 > 0i)))];
let _e20968 = (((((select(_e20929, _e20933, _e487) + 0.5f) / _e19762) * 2f) - 1f) * _e19770);
let _e20973 = ((1f - (((select(_e20933, _e20929, _e487) + 0.5f) / _e19763) * 2f)) * _e19778);
let _e20980 = ((_e19781.member * _e20968) + (_e19789.member * _e20973));
let _e20981 = ((_e19781.member_1 * _e20968) + (_e19789.member_1 * _e20973));
let _e20982 = ((_e19781.member_2 * _e20968) + (_e19789.member_2 * _e20973));
let _e20986 = select((_e19804.member + _e20980), _e19804.member, _e19802);
let _e20987 = select((_e19804.member_1 + _e20981), _e19804.member_1, _e19802);
let _e20988 = select((_e19804.member_2 + _e20982), _e19804.member_2, _e19802);
let _e20999 = (((_e20986 * _e20986) + (_e20987 * _e20987)) + (_e20988 * _e20988));
let _e21003 = (1f / sqrt(select(0f, _e20999, (_e20999 > 0f))));
let _e21004 = (_e20986 * _e21003);
let _e21005 = (_e20987 * _e21003);
let _e21006 = (_e20988 * _e21003);
let _e21007 = (_e609 - select(_e19815.member, (_e19815.member + _e20980), _e19802));
let _e21008 = (_e621 - select(_e19815.member_1, (_e19815.member_1 + _e20981), _e19802));
let _e21009 = (_e634 - select(_e19815.member_2, (_e19815.member_2 + _e20982), _e19802));
let _e21014 = (((_e21007 * _e21004) + (_e21008 * _e21005)) + (_e21009 * _e21006));
let _e21019 = (((_e21007 * _e647) + (_e21008 * _e660)) + (_e21009 * _e673));
let _e21024 = (((_e21004 * _e647) + (_e21005 * _e660)) + (_e21006 * _e673));
let _e21027 = ((_e21005 * _e673) - (_e21006 * _e660));
let _e21030 = ((_e21006 * _e647) - (_e21004 * _e673));
let _e21033 = ((_e21004 * _e660) - (_e21005 * _e647));
let _e21038 = (((_e21027 * _e21027) + (_e21030 * _e21030)) + (_e21033 * _e21033));
let _e21041 = (1f / select(1e-9f, _e21038, (_e21038 > 1e-9f)));
let _e21044 = ((_e21014 - (_e21024 * _e21019)) * _e21041);
let _e21047 = (((_e21024 * _e21014) - _e21019) * _e21041);
let _e21053 = select(0f, _e21044, (((_e21047 >= 0f) && (_e21047 < _e725)) && (_e21044 > 0f)));
let _e21055 = (_e20919 << bitcast<u32>(_e20531));
if _e20767 {
phi_19300_ = (_e20547.member - 1i);
} else {
phi_19300_ = _e20766;
}
let _e21070 = phi_19300_;
if _e20922 {
phi_19311_ = (_e20547.member_1 - 1i);
} else {
phi_19311_ = _e20921;
}
let _e21073 = phi_19311_;
let _e21077 = (((f32(_e21070) + 0.5f) * _e20552) - 0.5f);
let _e21081 = (((f32(_e21073) + 0.5f) * _e20552) - 0.5f);
if _e487 {
phi_19339_ = type_26(_e21073, _e21070);
} else {
phi_19339_ = type_26(_e21070, _e21073);
}
let _e21087 = phi_19339_;
if _e11998 {
phi_19390_ = 0u;
} else {
if (_e800 == 1u) {
phi_19389_ = 0u;
} else {
if (_e800 == 2u) {
phi_19388_ = _e20629;
} else {
phi_19388_ = select(_e20635, _e20632, (_e800 == 3u));
}
let _e21095 = phi_19388_;
phi_19389_ = _e21095;
}
let _e21097 = phi_19389_;
phi_19390_ = _e21097;
}
let _e21099 = phi_19390_;
local_170 = (((bitcast<i32>(_e21099) + _e21087.member_1) * _e20626) + _e21087.member);
let _e21104 = local_170;
let _e21106 = select(_e20652, _e21104, (_e21104 < _e20652));
let _e21111 = global_6.member[bitcast<u32>(select(0i, _e21106, (_e21106 > 0i)))];
let _e21116 = (((((select(_e21077, _e21081, _e487) + 0.5f) / _e19762) * 2f) - 1f) * _e19770);
let _e21121 = ((1f - (((select(_e21081, _e21077, _e487) + 0.5f) / _e19763) * 2f)) * _e19778);
let _e21128 = ((_e19781.member * _e21116) + (_e19789.member * _e21121));
let _e21129 = ((_e19781.member_1 * _e21116) + (_e19789.member_1 * _e21121));
let _e21130 = ((_e19781.member_2 * _e21116) + (_e19789.member_2 * _e21121));
let _e21134 = select((_e19804.member + _e21128), _e19804.member, _e19802);
let _e21135 = select((_e19804.member_1 + _e21129), _e19804.member_1, _e19802);
let _e21136 = select((_e19804.member_2 + _e21130), _e19804.member_2, _e19802);
let _e21147 = (((_e21134 * _e21134) + (_e21135 * _e21135)) + (_e21136 * _e21136));
let _e21151 = (1f / sqrt(select(0f, _e21147, (_e21147 > 0f))));
let _e21152 = (_e21134 * _e21151);
let _e21153 = (_e21135 * _e21151);
let _e21154 = (_e21136 * _e21151);
let _e21155 = (_e609 - select(_e19815.member, (_e19815.member + _e21128), _e19802));
let _e21156 = (_e621 - select(_e19815.member_1, (_e19815.member_1 + _e21129), _e19802));
let _e21157 = (_e634 - select(_e19815.member_2, (_e19815.member_2 + _e21130), _e19802));
let _e21162 = (((_e21155 * _e21152) + (_e21156 * _e21153)) + (_e21157 * _e21154));
let _e21167 = (((_e21155 * _e647) + (_e21156 * _e660)) + (_e21157 * _e673));
let _e21172 = (((_e21152 * _e647) + (_e21153 * _e660)) + (_e21154 * _e673));
let _e21175 = ((_e21153 * _e673) - (_e21154 * _e660));
let _e21178 = ((_e21154 * _e647) - (_e21152 * _e673));
let _e21181 = ((_e21152 * _e660) - (_e21153 * _e647));
let _e21186 = (((_e21175 * _e21175) + (_e21178 * _e21178)) + (_e21181 * _e21181));
let _e21189 = (1f / select(1e-9f, _e21186, (_e21186 > 1e-9f)));
let _e21192 = ((_e21162 - (_e21172 * _e21167)) * _e21189);
let _e21195 = (((_e21172 * _e21162) - _e21167) * _e21189);
let _e21201 = select(0f, _e21192, (((_e21195 >= 0f) && (_e21195 < _e725)) && (_e21192 > 0f)));
let _e21203 = (_e21070 << bitcast<u32>(_e20531));
let _e21215 = select(((((1f - select(0f, (_e20592 * _e20593), (((select(select(_e800, _e957, (_e20751 >= _e726)), _e879, (_e20751 < _e332)) == _e800) && (_e20749 > 0f)) && (_e20749 < _e20659)))) - select(0f, (_e20589 * _e20593), (((select(select(_e800, _e957, (_e20903 >= _e726)), _e879, (_e20903 < _e332)) == _e800) && (_e20901 > 0f)) && (_e20901 < _e20811)))) - select(0f, (_e20592 * _e20591), (((select(select(_e800, _e957, (_e21055 >= _e726)), _e879, (_e21055 < _e332)) == _e800) && (_e21053 > 0f)) && (_e21053 < _e20963)))) - select(0f, (_e20589 * _e20591), (((select(select(_e800, _e957, (_e21203 >= _e726)), _e879, (_e21203 < _e332)) == _e800) && (_e21201 > 0f)) && (_e21201 < _e21111)))), 1f, _e11998);
let _e21216 = (_e19556 & 31u);
let _e21218 = (1u << bitcast<u32>(_e21216));
let _e21227 = bitcast<i32>((((_e11943 + _e21218) - 1u) >> bitcast<u32>(_e21216)));
let _e21228 = bitcast<i32>((((_e11946 + _e21218) - 1u) >> bitcast<u32>(_e21216)));
if _e487 {
phi_20392_ = type_26(_e21228, _e21227);
} else {
phi_20392_ = type_26(_e21227, _e21228);
}
let _e21232 = phi_20392_;
let _e21237 = f32((1i << bitcast<u32>(_e21216)));
let _e21238 = (1f / _e21237);
let _e21240 = ((_e19577 * _e21238) - 0.5f);
let _e21242 = ((_e19670 * _e21238) - 0.5f);
let _e21244 = select(-1f, _e21240, (_e21240 > -1f));
let _e21246 = select(1e6f, _e21244, (_e21244 < 1e6f));
let _e21253 = select(0i, select(select(i32(_e21246), i32(-2147483648), (_e21246 < -2147483600f)), 2147483647i, (_e21246 > 2147483500f)), (_e21246 == _e21246));
let _e21257 = (_e21253 - select(0i, 1i, (_e21246 < f32(_e21253))));
let _e21259 = select(-1f, _e21242, (_e21242 > -1f));
let _e21261 = select(1e6f, _e21259, (_e21259 < 1e6f));
let _e21268 = select(0i, select(select(i32(_e21261), i32(-2147483648), (_e21261 < -2147483600f)), 2147483647i, (_e21261 > 2147483500f)), (_e21261 == _e21261));
let _e21272 = (_e21268 - select(0i, 1i, (_e21261 < f32(_e21268))));
let _e21274 = (_e21240 - f32(_e21257));
let _e21276 = (_e21242 - f32(_e21272));
let _e21277 = (1f - _e21274);
let _e21278 = (1f - _e21276);
let _e21281 = select(_e21257, 0i, (_e21257 < 0i));
let _e21282 = (_e21281 >= _e21232.member);
if _e21282 {
phi_20470_ = (_e21232.member - 1i);
} else {
phi_20470_ = _e21281;
}
let _e21285 = phi_20470_;
let _e21287 = select(_e21272, 0i, (_e21272 < 0i));
let _e21288 = (_e21287 >= _e21232.member_1);
if _e21288 {
phi_20481_ = (_e21232.member_1 - 1i);
} else {
phi_20481_ = _e21287;
}
let _e21291 = phi_20481_;
let _e21295 = (((f32(_e21285) + 0.5f) * _e21237) - 0.5f);
let _e21299 = (((f32(_e21291) + 0.5f) * _e21237) - 0.5f);
if _e487 {
phi_20509_ = type_26(_e21291, _e21285);
} else {
phi_20509_ = type_26(_e21285, _e21291);
}
let _e21305 = phi_20509_;
let _e21308 = (_e19556 == 0u);
if _e21308 {
phi_20560_ = 0u;
} else {
if (_e19556 == 1u) {
phi_20559_ = 0u;
} else {
if (_e19556 == 2u) {
phi_20558_ = _e20629;
} else {
phi_20558_ = select(_e20635, _e20632, (_e19556 == 3u));
}
let _e21314 = phi_20558_;
phi_20559_ = _e21314;
}
let _e21316 = phi_20559_;
phi_20560_ = _e21316;
}
let _e21318 = phi_20560_;
local_168 = (((bitcast<i32>(_e21318) + _e21305.member_1) * _e20626) + _e21305.member);
let _e21323 = local_168;
let _e21325 = select(_e20652, _e21323, (_e21323 < _e20652));
let _e21330 = global_6.member[bitcast<u32>(select(0i, _e21325, (_e21325 > 0i)))];
let _e21335 = (((((select(_e21295, _e21299, _e487) + 0.5f) / _e19762) * 2f) - 1f) * _e19770);
let _e21340 = ((1f - (((select(_e21299, _e21295, _e487) + 0.5f) / _e19763) * 2f)) * _e19778);
let _e21347 = ((_e19781.member * _e21335) + (_e19789.member * _e21340));
let _e21348 = ((_e19781.member_1 * _e21335) + (_e19789.member_1 * _e21340));
let _e21349 = ((_e19781.member_2 * _e21335) + (_e19789.member_2 * _e21340));
let _e21353 = select((_e19804.member + _e21347), _e19804.member, _e19802);
let _e21354 = select((_e19804.member_1 + _e21348), _e19804.member_1, _e19802);
let _e21355 = select((_e19804.member_2 + _e21349), _e19804.member_2, _e19802);
let _e21366 = (((_e21353 * _e21353) + (_e21354 * _e21354)) + (_e21355 * _e21355));
let _e21370 = (1f / sqrt(select(0f, _e21366, (_e21366 > 0f))));
let _e21371 = (_e21353 * _e21370);
let _e21372 = (_e21354 * _e21370);
let _e21373 = (_e21355 * _e21370);
let _e21374 = (_e609 - select(_e19815.member, (_e19815.member + _e21347), _e19802));
let _e21375 = (_e621 - select(_e19815.member_1, (_e19815.member_1 + _e21348), _e19802));
let _e21376 = (_e634 - select(_e19815.member_2, (_e19815.member_2 + _e21349), _e19802));
let _e21381 = (((_e21374 * _e21371) + (_e21375 * _e21372)) + (_e21376 * _e21373));
let _e21386 = (((_e21374 * _e647) + (_e21375 * _e660)) + (_e21376 * _e673));
let _e21391 = (((_e21371 * _e647) + (_e21372 * _e660)) + (_e21373 * _e673));
let _e21394 = ((_e21372 * _e673) - (_e21373 * _e660));
let _e21397 = ((_e21373 * _e647) - (_e21371 * _e673));
let _e21400 = ((_e21371 * _e660) - (_e21372 * _e647));
let _e21405 = (((_e21394 * _e21394) + (_e21397 * _e21397)) + (_e21400 * _e21400));
let _e21408 = (1f / select(1e-9f, _e21405, (_e21405 > 1e-9f)));
let _e21411 = ((_e21381 - (_e21391 * _e21386)) * _e21408);
let _e21414 = (((_e21391 * _e21381) - _e21386) * _e21408);
let _e21420 = select(0f, _e21411, (((_e21414 >= 0f) && (_e21414 < _e725)) && (_e21411 > 0f)));
let _e21422 = (_e21285 << bitcast<u32>(_e21216));
let _e21434 = (_e21257 + 1i);
let _e21437 = select(_e21434, 0i, (_e21434 < 0i));
let _e21438 = (_e21437 >= _e21232.member);
if _e21438 {
phi_21544_ = (_e21232.member - 1i);
} else {
phi_21544_ = _e21437;
}
let _e21441 = phi_21544_;
if _e21288 {
phi_21555_ = (_e21232.member_1 - 1i);
} else {
phi_21555_ = _e21287;
}
let _e21444 = phi_21555_;
let _e21448 = (((f32(_e21441) + 0.5f) * _e21237) - 0.5f);
let _e21452 = (((f32(_e21444) + 0.5f) * _e21237) - 0.5f);
if _e487 {
phi_21583_ = type_26(_e21444, _e21441);
} else {
phi_21583_ = type_26(_e21441, _e21444);
}
let _e21458 = phi_21583_;
if _e21308 {
phi_21634_ = 0u;
} else {
if (_e19556 == 1u) {
phi_21633_ = 0u;
} else {
if (_e19556 == 2u) {
phi_21632_ = _e20629;
} else {
phi_21632_ = select(_e20635, _e20632, (_e19556 == 3u));
}
let _e21466 = phi_21632_;
phi_21633_ = _e21466;
}
let _e21468 = phi_21633_;
phi_21634_ = _e21468;
}
let _e21470 = phi_21634_;
local_166 = (((bitcast<i32>(_e21470) + _e21458.member_1) * _e20626) + _e21458.member);
let _e21475 = local_166;
let _e21477 = select(_e20652, _e21475, (_e21475 < _e20652));
let _e21482 = global_6.member[bitcast<u32>(select(0i, _e21477, (_e21477 > 0i)))];
let _e21487 = (((((select(_e21448, _e21452, _e487) + 0.5f) / _e19762) * 2f) - 1f) * _e19770);
let _e21492 = ((1f - (((select(_e21452, _e21448, _e487) + 0.5f) / _e19763) * 2f)) * _e19778);
let _e21499 = ((_e19781.member * _e21487) + (_e19789.member * _e21492));
let _e21500 = ((_e19781.member_1 * _e21487) + (_e19789.member_1 * _e21492));
let _e21501 = ((_e19781.member_2 * _e21487) + (_e19789.member_2 * _e21492));
let _e21505 = select((_e19804.member + _e21499), _e19804.member, _e19802);
let _e21506 = select((_e19804.member_1 + _e21500), _e19804.member_1, _e19802);
let _e21507 = select((_e19804.member_2 + _e21501), _e19804.member_2, _e19802);
let _e21518 = (((_e21505 * _e21505) + (_e21506 * _e21506)) + (_e21507 * _e21507));
let _e21522 = (1f / sqrt(select(0f, _e21518, (_e21518 > 0f))));
let _e21523 = (_e21505 * _e21522);
let _e21524 = (_e21506 * _e21522);
let _e21525 = (_e21507 * _e21522);
let _e21526 = (_e609 - select(_e19815.member, (_e19815.member + _e21499), _e19802));
let _e21527 = (_e621 - select(_e19815.member_1, (_e19815.member_1 + _e21500), _e19802));
let _e21528 = (_e634 - select(_e19815.member_2, (_e19815.member_2 + _e21501), _e19802));
let _e21533 = (((_e21526 * _e21523) + (_e21527 * _e21524)) + (_e21528 * _e21525));
let _e21538 = (((_e21526 * _e647) + (_e21527 * _e660)) + (_e21528 * _e673));
let _e21543 = (((_e21523 * _e647) + (_e21524 * _e660)) + (_e21525 * _e673));
let _e21546 = ((_e21524 * _e673) - (_e21525 * _e660));
let _e21549 = ((_e21525 * _e647) - (_e21523 * _e673));
let _e21552 = ((_e21523 * _e660) - (_e21524 * _e647));
let _e21557 = (((_e21546 * _e21546) + (_e21549 * _e21549)) + (_e21552 * _e21552));
let _e21560 = (1f / select(1e-9f, _e21557, (_e21557 > 1e-9f)));
let _e21563 = ((_e21533 - (_e21543 * _e21538)) * _e21560);
let _e21566 = (((_e21543 * _e21533) - _e21538) * _e21560);
let _e21572 = select(0f, _e21563, (((_e21566 >= 0f) && (_e21566 < _e725)) && (_e21563 > 0f)));
let _e21574 = (_e21441 << bitcast<u32>(_e21216));
let _e21586 = (_e21272 + 1i);
if _e21282 {
phi_22618_ = (_e21232.member - 1i);
} else {
phi_22618_ = _e21281;
}
let _e21590 = phi_22618_;
let _e21592 = select(_e21586, 0i, (_e21586 < 0i));
let _e21593 = (_e21592 >= _e21232.member_1);
if _e21593 {
phi_22629_ = (_e21232.member_1 - 1i);
} else {
phi_22629_ = _e21592;
}
let _e21596 = phi_22629_;
let _e21600 = (((f32(_e21590) + 0.5f) * _e21237) - 0.5f);
let _e21604 = (((f32(_e21596) + 0.5f) * _e21237) - 0.5f);
if _e487 {
phi_22657_ = type_26(_e21596, _e21590);
} else {
phi_22657_ = type_26(_e21590, _e21596);
}
let _e21610 = phi_22657_;
if _e21308 {
phi_22708_ = 0u;
} else {
if (_e19556 == 1u) {
phi_22707_ = 0u;
} else {
if (_e19556 == 2u) {
phi_22706_ = _e20629;
} else {
phi_22706_ = select(_e20635, _e20632, (_e19556 == 3u));
}
let _e21618 = phi_22706_;
phi_22707_ = _e21618;
}
let _e21620 = phi_22707_;
phi_22708_ = _e21620;
}
let _e21622 = phi_22708_;
local_164 = (((bitcast<i32>(_e21622) + _e21610.member_1) * _e20626) + _e21610.member);
let _e21627 = local_164;
let _e21629 = select(_e20652, _e21627, (_e21627 < _e20652));
let _e21634 = global_6.member[bitcast<u32>(select(0i, _e21629, (_e21629 > 0i)))];
let _e21639 = (((((select(_e21600, _e21604, _e487) + 0.5f) / _e19762) * 2f) - 1f) * _e19770);
let _e21644 = ((1f - (((select(_e21604, _e21600, _e487) + 0.5f) / _e19763) * 2f)) * _e19778);
let _e21651 = ((_e19781.member * _e21639) + (_e19789.member * _e21644));
let _e21652 = ((_e19781.member_1 * _e21639) + (_e19789.member_1 * _e21644));
let _e21653 = ((_e19781.member_2 * _e21639) + (_e19789.member_2 * _e21644));
let _e21657 = select((_e19804.member + _e21651), _e19804.member, _e19802);
let _e21658 = select((_e19804.member_1 + _e21652), _e19804.member_1, _e19802);
let _e21659 = select((_e19804.member_2 + _e21653), _e19804.member_2, _e19802);
let _e21670 = (((_e21657 * _e21657) + (_e21658 * _e21658)) + (_e21659 * _e21659));
let _e21674 = (1f / sqrt(select(0f, _e21670, (_e21670 > 0f))));
let _e21675 = (_e21657 * _e21674);
let _e21676 = (_e21658 * _e21674);
let _e21677 = (_e21659 * _e21674);
let _e21678 = (_e609 - select(_e19815.member, (_e19815.member + _e21651), _e19802));
let _e21679 = (_e621 - select(_e19815.member_1, (_e19815.member_1 + _e21652), _e19802));
let _e21680 = (_e634 - select(_e19815.member_2, (_e19815.member_2 + _e21653), _e19802));
let _e21685 = (((_e21678 * _e21675) + (_e21679 * _e21676)) + (_e21680 * _e21677));
let _e21690 = (((_e21678 * _e647) + (_e21679 * _e660)) + (_e21680 * _e673));
let _e21695 = (((_e21675 * _e647) + (_e21676 * _e660)) + (_e21677 * _e673));
let _e21698 = ((_e21676 * _e673) - (_e21677 * _e660));
let _e21701 = ((_e21677 * _e647) - (_e21675 * _e673));
let _e21704 = ((_e21675 * _e660) - (_e21676 * _e647));
let _e21709 = (((_e21698 * _e21698) + (_e21701 * _e21701)) + (_e21704 * _e21704));
let _e21712 = (1f / select(1e-9f, _e21709, (_e21709 > 1e-9f)));
let _e21715 = ((_e21685 - (_e21695 * _e21690)) * _e21712);
let _e21718 = (((_e21695 * _e21685) - _e21690) * _e21712);
let _e21724 = select(0f, _e21715, (((_e21718 >= 0f) && (_e21718 < _e725)) && (_e21715 > 0f)));
let _e21726 = (_e21590 << bitcast<u32>(_e21216));
if _e21438 {
phi_23692_ = (_e21232.member - 1i);
} else {
phi_23692_ = _e21437;
}
let _e21741 = phi_23692_;
if _e21593 {
phi_23703_ = (_e21232.member_1 - 1i);
} else {
phi_23703_ = _e21592;
}
let _e21744 = phi_23703_;
let _e21748 = (((f32(_e21741) + 0.5f) * _e21237) - 0.5f);
let _e21752 = (((f32(_e21744) + 0.5f) * _e21237) - 0.5f);
if _e487 {
phi_23731_ = type_26(_e21744, _e21741);
} else {
phi_23731_ = type_26(_e21741, _e21744);
}
let _e21758 = phi_23731_;
if _e21308 {
phi_23782_ = 0u;
} else {
if (_e19556 == 1u) {
phi_23781_ = 0u;
} else {
if (_e19556 == 2u) {
phi_23780_ = _e20629;
} else {
phi_23780_ = select(_e20635, _e20632, (_e19556 == 3u));
}
let _e21766 = phi_23780_;
phi_23781_ = _e21766;
}
let _e21768 = phi_23781_;
phi_23782_ = _e21768;
}
let _e21770 = phi_23782_;
local_162 = (((bitcast<i32>(_e21770) + _e21758.member_1) * _e20626) + _e21758.member);
let _e21775 = local_162;
let _e21777 = select(_e20652, _e21775, (_e21775 < _e20652));
let _e21782 = global_6.member[bitcast<u32>(select(0i, _e21777, (_e21777 > 0i)))];
let _e21787 = (((((select(_e21748, _e21752, _e487) + 0.5f) / _e19762) * 2f) - 1f) * _e19770);
let _e21792 = ((1f - (((select(_e21752, _e21748, _e487) + 0.5f) / _e19763) * 2f)) * _e19778);
let _e21799 = ((_e19781.member * _e21787) + (_e19789.member * _e21792));
let _e21800 = ((_e19781.member_1 * _e21787) + (_e19789.member_1 * _e21792));
let _e21801 = ((_e19781.member_2 * _e21787) + (_e19789.member_2 * _e21792));
let _e21805 = select((_e19804.member + _e21799), _e19804.member, _e19802);
let _e21806 = select((_e19804.member_1 + _e21800), _e19804.member_1, _e19802);
let _e21807 = select((_e19804.member_2 + _e21801), _e19804.member_2, _e19802);
let _e21818 = (((_e21805 * _e21805) + (_e21806 * _e21806)) + (_e21807 * _e21807));
let _e21822 = (1f / sqrt(select(0f, _e21818, (_e21818 > 0f))));
let _e21823 = (_e21805 * _e21822);
let _e21824 = (_e21806 * _e21822);
let _e21825 = (_e21807 * _e21822);
let _e21826 = (_e609 - select(_e19815.member, (_e19815.member + _e21799), _e19802));
let _e21827 = (_e621 - select(_e19815.member_1, (_e19815.member_1 + _e21800), _e19802));
let _e21828 = (_e634 - select(_e19815.member_2, (_e19815.member_2 + _e21801), _e19802));
let _e21833 = (((_e21826 * _e21823) + (_e21827 * _e21824)) + (_e21828 * _e21825));
let _e21838 = (((_e21826 * _e647) + (_e21827 * _e660)) + (_e21828 * _e673));
let _e21843 = (((_e21823 * _e647) + (_e21824 * _e660)) + (_e21825 * _e673));
let _e21846 = ((_e21824 * _e673) - (_e21825 * _e660));
let _e21849 = ((_e21825 * _e647) - (_e21823 * _e673));
let _e21852 = ((_e21823 * _e660) - (_e21824 * _e647));
let _e21857 = (((_e21846 * _e21846) + (_e21849 * _e21849)) + (_e21852 * _e21852));
let _e21860 = (1f / select(1e-9f, _e21857, (_e21857 > 1e-9f)));
let _e21863 = ((_e21833 - (_e21843 * _e21838)) * _e21860);
let _e21866 = (((_e21843 * _e21833) - _e21838) * _e21860);
let _e21872 = select(0f, _e21863, (((_e21866 >= 0f) && (_e21866 < _e725)) && (_e21863 > 0f)));
let _e21874 = (_e21741 << bitcast<u32>(_e21216));
let _e21886 = select(((((_e21215 - select(0f, (_e21277 * _e21278), (((select(select(_e800, _e957, (_e21422 >= _e726)), _e879, (_e21422 < _e332)) == _e19556) && (_e21420 > 0f)) && (_e21420 < _e21330)))) - select(0f, (_e21274 * _e21278), (((select(select(_e800, _e957, (_e21574 >= _e726)), _e879, (_e21574 < _e332)) == _e19556) && (_e21572 > 0f)) && (_e21572 < _e21482)))) - select(0f, (_e21277 * _e21276), (((select(select(_e800, _e957, (_e21726 >= _e726)), _e879, (_e21726 < _e332)) == _e19556) && (_e21724 > 0f)) && (_e21724 < _e21634)))) - select(0f, (_e21274 * _e21276), (((select(select(_e800, _e957, (_e21874 >= _e726)), _e879, (_e21874 < _e332)) == _e19556) && (_e21872 > 0f)) && (_e21872 < _e21782)))), _e21215, _e21308);
let _e21887 = (_e19560 & 31u);
let _e21889 = (1u << bitcast<u32>(_e21887));
let _e21898 = bitcast<i32>((((_e11943 + _e21889) - 1u) >> bitcast<u32>(_e21887)));
let _e21899 = bitcast<i32>((((_e11946 + _e21889) - 1u) >> bitcast<u32>(_e21887)));
if _e487 {
phi_24784_ = type_26(_e21899, _e21898);
} else {
phi_24784_ = type_26(_e21898, _e21899);
}
let _e21903 = phi_24784_;
let _e21908 = f32((1i << bitcast<u32>(_e21887)));
let _e21909 = (1f / _e21908);
let _e21911 = ((_e19577 * _e21909) - 0.5f);
let _e21913 = ((_e19670 * _e21909) - 0.5f);
let _e21915 = select(-1f, _e21911, (_e21911 > -1f));
let _e21917 = select(1e6f, _e21915, (_e21915 < 1e6f));
let _e21924 = select(0i, select(select(i32(_e21917), i32(-2147483648), (_e21917 < -2147483600f)), 2147483647i, (_e21917 > 2147483500f)), (_e21917 == _e21917));
let _e21928 = (_e21924 - select(0i, 1i, (_e21917 < f32(_e21924))));
let _e21930 = select(-1f, _e21913, (_e21913 > -1f));
let _e21932 = select(1e6f, _e21930, (_e21930 < 1e6f));
let _e21939 = select(0i, select(select(i32(_e21932), i32(-2147483648), (_e21932 < -2147483600f)), 2147483647i, (_e21932 > 2147483500f)), (_e21932 == _e21932));
let _e21943 = (_e21939 - select(0i, 1i, (_e21932 < f32(_e21939))));
let _e21945 = (_e21911 - f32(_e21928));
let _e21947 = (_e21913 - f32(_e21943));
let _e21948 = (1f - _e21945);
let _e21949 = (1f - _e21947);
let _e21952 = select(_e21928, 0i, (_e21928 < 0i));
let _e21953 = (_e21952 >= _e21903.member);
if _e21953 {
phi_24862_ = (_e21903.member - 1i);
} else {
phi_24862_ = _e21952;
}
let _e21956 = phi_24862_;
let _e21958 = select(_e21943, 0i, (_e21943 < 0i));
let _e21959 = (_e21958 >= _e21903.member_1);
if _e21959 {
phi_24873_ = (_e21903.member_1 - 1i);
} else {
phi_24873_ = _e21958;
}
let _e21962 = phi_24873_;
let _e21966 = (((f32(_e21956) + 0.5f) * _e21908) - 0.5f);
let _e21970 = (((f32(_e21962) + 0.5f) * _e21908) - 0.5f);
if _e487 {
phi_24901_ = type_26(_e21962, _e21956);
} else {
phi_24901_ = type_26(_e21956, _e21962);
}
let _e21976 = phi_24901_;
let _e21979 = (_e19560 == 0u);
if _e21979 {
phi_24952_ = 0u;
} else {
if (_e19560 == 1u) {
phi_24951_ = 0u;
} else {
if (_e19560 == 2u) {
phi_24950_ = _e20629;
} else {
phi_24950_ = select(_e20635, _e20632, (_e19560 == 3u));
}
let _e21985 = phi_24950_;
phi_24951_ = _e21985;
}
let _e21987 = phi_24951_;
phi_24952_ = _e21987;
}
let _e21989 = phi_24952_;
local_160 = (((bitcast<i32>(_e21989) + _e21976.member_1) * _e20626) + _e21976.member);
let _e21994 = local_160;
let _e21996 = select(_e20652, _e21994, (_e21994 < _e20652));
let _e22001 = global_6.member[bitcast<u32>(select(0i, _e21996, (_e21996 > 0i)))];
let _e22006 = (((((select(_e21966, _e21970, _e487) + 0.5f) / _e19762) * 2f) - 1f) * _e19770);
let _e22011 = ((1f - (((select(_e21970, _e21966, _e487) + 0.5f) / _e19763) * 2f)) * _e19778);
let _e22018 = ((_e19781.member * _e22006) + (_e19789.member * _e22011));
let _e22019 = ((_e19781.member_1 * _e22006) + (_e19789.member_1 * _e22011));
let _e22020 = ((_e19781.member_2 * _e22006) + (_e19789.member_2 * _e22011));
let _e22024 = select((_e19804.member + _e22018), _e19804.member, _e19802);
let _e22025 = select((_e19804.member_1 + _e22019), _e19804.member_1, _e19802);
let _e22026 = select((_e19804.member_2 + _e22020), _e19804.member_2, _e19802);
let _e22037 = (((_e22024 * _e22024) + (_e22025 * _e22025)) + (_e22026 * _e22026));
let _e22041 = (1f / sqrt(select(0f, _e22037, (_e22037 > 0f))));
let _e22042 = (_e22024 * _e22041);
let _e22043 = (_e22025 * _e22041);
let _e22044 = (_e22026 * _e22041);
let _e22045 = (_e609 - select(_e19815.member, (_e19815.member + _e22018), _e19802));
let _e22046 = (_e621 - select(_e19815.member_1, (_e19815.member_1 + _e22019), _e19802));
let _e22047 = (_e634 - select(_e19815.member_2, (_e19815.member_2 + _e22020), _e19802));
let _e22052 = (((_e22045 * _e22042) + (_e22046 * _e22043)) + (_e22047 * _e22044));
let _e22057 = (((_e22045 * _e647) + (_e22046 * _e660)) + (_e22047 * _e673));
let _e22062 = (((_e22042 * _e647) + (_e22043 * _e660)) + (_e22044 * _e673));
let _e22065 = ((_e22043 * _e673) - (_e22044 * _e660));
let _e22068 = ((_e22044 * _e647) - (_e22042 * _e673));
let _e22071 = ((_e22042 * _e660) - (_e22043 * _e647));
let _e22076 = (((_e22065 * _e22065) + (_e22068 * _e22068)) + (_e22071 * _e22071));
let _e22079 = (1f / select(1e-9f, _e22076, (_e22076 > 1e-9f)));
let _e22082 = ((_e22052 - (_e22062 * _e22057)) * _e22079);
let _e22085 = (((_e22062 * _e22052) - _e22057) * _e22079);
let _e22091 = select(0f, _e22082, (((_e22085 >= 0f) && (_e22085 < _e725)) && (_e22082 > 0f)));
let _e22093 = (_e21956 << bitcast<u32>(_e21887));
let _e22105 = (_e21928 + 1i);
let _e22108 = select(_e22105, 0i, (_e22105 < 0i));
let _e22109 = (_e22108 >= _e21903.member);
if _e22109 {
phi_25936_ = (_e21903.member - 1i);
} else {
phi_25936_ = _e22108;
}
let _e22112 = phi_25936_;
if _e21959 {
phi_25947_ = (_e21903.member_1 - 1i);
} else {
phi_25947_ = _e21958;
}
let _e22115 = phi_25947_;
let _e22119 = (((f32(_e22112) + 0.5f) * _e21908) - 0.5f);
let _e22123 = (((f32(_e22115) + 0.5f) * _e21908) - 0.5f);
if _e487 {
phi_25975_ = type_26(_e22115, _e22112);
} else {
phi_25975_ = type_26(_e22112, _e22115);
}
let _e22129 = phi_25975_;
if _e21979 {
phi_26026_ = 0u;
} else {
if (_e19560 == 1u) {
phi_26025_ = 0u;
} else {
if (_e19560 == 2u) {
phi_26024_ = _e20629;
} else {
phi_26024_ = select(_e20635, _e20632, (_e19560 == 3u));
}
let _e22137 = phi_26024_;
phi_26025_ = _e22137;
}
let _e22139 = phi_26025_;
phi_26026_ = _e22139;
}
let _e22141 = phi_26026_;
local_158 = (((bitcast<i32>(_e22141) + _e22129.member_1) * _e20626) + _e22129.member);
let _e22146 = local_158;
let _e22148 = select(_e20652, _e22146, (_e22146 < _e20652));
let _e22153 = global_6.member[bitcast<u32>(select(0i, _e22148, (_e22148 > 0i)))];
let _e22158 = (((((select(_e22119, _e22123, _e487) + 0.5f) / _e19762) * 2f) - 1f) * _e19770);
let _e22163 = ((1f - (((select(_e22123, _e22119, _e487) + 0.5f) / _e19763) * 2f)) * _e19778);
let _e22170 = ((_e19781.member * _e22158) + (_e19789.member * _e22163));
let _e22171 = ((_e19781.member_1 * _e22158) + (_e19789.member_1 * _e22163));
let _e22172 = ((_e19781.member_2 * _e22158) + (_e19789.member_2 * _e22163));
let _e22176 = select((_e19804.member + _e22170), _e19804.member, _e19802);
let _e22177 = select((_e19804.member_1 + _e22171), _e19804.member_1, _e19802);
let _e22178 = select((_e19804.member_2 + _e22172), _e19804.member_2, _e19802);
let _e22189 = (((_e22176 * _e22176) + (_e22177 * _e22177)) + (_e22178 * _e22178));
let _e22193 = (1f / sqrt(select(0f, _e22189, (_e22189 > 0f))));
let _e22194 = (_e22176 * _e22193);
let _e22195 = (_e22177 * _e22193);
let _e22196 = (_e22178 * _e22193);
let _e22197 = (_e609 - select(_e19815.member, (_e19815.member + _e22170), _e19802));
let _e22198 = (_e621 - select(_e19815.member_1, (_e19815.member_1 + _e22171), _e19802));
let _e22199 = (_e634 - select(_e19815.member_2, (_e19815.member_2 + _e22172), _e19802));
let _e22204 = (((_e22197 * _e22194) + (_e22198 * _e22195)) + (_e22199 * _e22196));
let _e22209 = (((_e22197 * _e647) + (_e22198 * _e660)) + (_e22199 * _e673));
let _e22214 = (((_e22194 * _e647) + (_e22195 * _e660)) + (_e22196 * _e673));
let _e22217 = ((_e22195 * _e673) - (_e22196 * _e660));
let _e22220 = ((_e22196 * _e647) - (_e22194 * _e673));
let _e22223 = ((_e22194 * _e660) - (_e22195 * _e647));
let _e22228 = (((_e22217 * _e22217) + (_e22220 * _e22220)) + (_e22223 * _e22223));
let _e22231 = (1f / select(1e-9f, _e22228, (_e22228 > 1e-9f)));
let _e22234 = ((_e22204 - (_e22214 * _e22209)) * _e22231);
let _e22237 = (((_e22214 * _e22204) - _e22209) * _e22231);
let _e22243 = select(0f, _e22234, (((_e22237 >= 0f) && (_e22237 < _e725)) && (_e22234 > 0f)));
let _e22245 = (_e22112 << bitcast<u32>(_e21887));
let _e22257 = (_e21943 + 1i);
if _e21953 {
phi_27010_ = (_e21903.member - 1i);
} else {
phi_27010_ = _e21952;
}
let _e22261 = phi_27010_;
let _e22263 = select(_e22257, 0i, (_e22257 < 0i));
let _e22264 = (_e22263 >= _e21903.member_1);
if _e22264 {
phi_27021_ = (_e21903.member_1 - 1i);
} else {
phi_27021_ = _e22263;
}
let _e22267 = phi_27021_;
let _e22271 = (((f32(_e22261) + 0.5f) * _e21908) - 0.5f);
let _e22275 = (((f32(_e22267) + 0.5f) * _e21908) - 0.5f);
if _e487 {
phi_27049_ = type_26(_e22267, _e22261);
} else {
phi_27049_ = type_26(_e22261, _e22267);
}
let _e22281 = phi_27049_;
if _e21979 {
phi_27100_ = 0u;
} else {
if (_e19560 == 1u) {
phi_27099_ = 0u;
} else {
if (_e19560 == 2u) {
phi_27098_ = _e20629;
} else {
phi_27098_ = select(_e20635, _e20632, (_e19560 == 3u));
}
let _e22289 = phi_27098_;
phi_27099_ = _e22289;
}
let _e22291 = phi_27099_;
phi_27100_ = _e22291;
}
let _e22293 = phi_27100_;
local_156 = (((bitcast<i32>(_e22293) + _e22281.member_1) * _e20626) + _e22281.member);
let _e22298 = local_156;
let _e22300 = select(_e20652, _e22298, (_e22298 < _e20652));
let _e22305 = global_6.member[bitcast<u32>(select(0i, _e22300, (_e22300 > 0i)))];
let _e22310 = (((((select(_e22271, _e22275, _e487) + 0.5f) / _e19762) * 2f) - 1f) * _e19770);
let _e22315 = ((1f - (((select(_e22275, _e22271, _e487) + 0.5f) / _e19763) * 2f)) * _e19778);
let _e22322 = ((_e19781.member * _e22310) + (_e19789.member * _e22315));
let _e22323 = ((_e19781.member_1 * _e22310) + (_e19789.member_1 * _e22315));
let _e22324 = ((_e19781.member_2 * _e22310) + (_e19789.member_2 * _e22315));
let _e22328 = select((_e19804.member + _e22322), _e19804.member, _e19802);
let _e22329 = select((_e19804.member_1 + _e22323), _e19804.member_1, _e19802);
let _e22330 = select((_e19804.member_2 + _e22324), _e19804.member_2, _e19802);
let _e22341 = (((_e22328 * _e22328) + (_e22329 * _e22329)) + (_e22330 * _e22330));
let _e22345 = (1f / sqrt(select(0f, _e22341, (_e22341 > 0f))));
let _e22346 = (_e22328 * _e22345);
let _e22347 = (_e22329 * _e22345);
let _e22348 = (_e22330 * _e22345);
let _e22349 = (_e609 - select(_e19815.member, (_e19815.member + _e22322), _e19802));
let _e22350 = (_e621 - select(_e19815.member_1, (_e19815.member_1 + _e22323), _e19802));
let _e22351 = (_e634 - select(_e19815.member_2, (_e19815.member_2 + _e22324), _e19802));
let _e22356 = (((_e22349 * _e22346) + (_e22350 * _e22347)) + (_e22351 * _e22348));
let _e22361 = (((_e22349 * _e647) + (_e22350 * _e660)) + (_e22351 * _e673));
let _e22366 = (((_e22346 * _e647) + (_e22347 * _e660)) + (_e22348 * _e673));
let _e22369 = ((_e22347 * _e673) - (_e22348 * _e660));
let _e22372 = ((_e22348 * _e647) - (_e22346 * _e673));
let _e22375 = ((_e22346 * _e660) - (_e22347 * _e647));
let _e22380 = (((_e22369 * _e22369) + (_e22372 * _e22372)) + (_e22375 * _e22375));
let _e22383 = (1f / select(1e-9f, _e22380, (_e22380 > 1e-9f)));
let _e22386 = ((_e22356 - (_e22366 * _e22361)) * _e22383);
let _e22389 = (((_e22366 * _e22356) - _e22361) * _e22383);
let _e22395 = select(0f, _e22386, (((_e22389 >= 0f) && (_e22389 < _e725)) && (_e22386 > 0f)));
let _e22397 = (_e22261 << bitcast<u32>(_e21887));
if _e22109 {
phi_28084_ = (_e21903.member - 1i);
} else {
phi_28084_ = _e22108;
}
let _e22412 = phi_28084_;
if _e22264 {
phi_28095_ = (_e21903.member_1 - 1i);
} else {
phi_28095_ = _e22263;
}
let _e22415 = phi_28095_;
let _e22419 = (((f32(_e22412) + 0.5f) * _e21908) - 0.5f);
let _e22423 = (((f32(_e22415) + 0.5f) * _e21908) - 0.5f);
if _e487 {
phi_28123_ = type_26(_e22415, _e22412);
} else {
phi_28123_ = type_26(_e22412, _e22415);
}
let _e22429 = phi_28123_;
if _e21979 {
phi_28174_ = 0u;
} else {
if (_e19560 == 1u) {
phi_28173_ = 0u;
} else {
if (_e19560 == 2u) {
phi_28172_ = _e20629;
} else {
phi_28172_ = select(_e20635, _e20632, (_e19560 == 3u));
}
let _e22437 = phi_28172_;
phi_28173_ = _e22437;
}
let _e22439 = phi_28173_;
phi_28174_ = _e22439;
}
let _e22441 = phi_28174_;
local_154 = (((bitcast<i32>(_e22441) + _e22429.member_1) * _e20626) + _e22429.member);
let _e22446 = local_154;
let _e22448 = select(_e20652, _e22446, (_e22446 < _e20652));
let _e22453 = global_6.member[bitcast<u32>(select(0i, _e22448, (_e22448 > 0i)))];
let _e22458 = (((((select(_e22419, _e22423, _e487) + 0.5f) / _e19762) * 2f) - 1f) * _e19770);
let _e22463 = ((1f - (((select(_e22423, _e22419, _e487) + 0.5f) / _e19763) * 2f)) * _e19778);
let _e22470 = ((_e19781.member * _e22458) + (_e19789.member * _e22463));
let _e22471 = ((_e19781.member_1 * _e22458) + (_e19789.member_1 * _e22463));
let _e22472 = ((_e19781.member_2 * _e22458) + (_e19789.member_2 * _e22463));
let _e22476 = select((_e19804.member + _e22470), _e19804.member, _e19802);
let _e22477 = select((_e19804.member_1 + _e22471), _e19804.member_1, _e19802);
let _e22478 = select((_e19804.member_2 + _e22472), _e19804.member_2, _e19802);
let _e22489 = (((_e22476 * _e22476) + (_e22477 * _e22477)) + (_e22478 * _e22478));
let _e22493 = (1f / sqrt(select(0f, _e22489, (_e22489 > 0f))));
let _e22494 = (_e22476 * _e22493);
let _e22495 = (_e22477 * _e22493);
let _e22496 = (_e22478 * _e22493);
let _e22497 = (_e609 - select(_e19815.member, (_e19815.member + _e22470), _e19802));
let _e22498 = (_e621 - select(_e19815.member_1, (_e19815.member_1 + _e22471), _e19802));
let _e22499 = (_e634 - select(_e19815.member_2, (_e19815.member_2 + _e22472), _e19802));
let _e22504 = (((_e22497 * _e22494) + (_e22498 * _e22495)) + (_e22499 * _e22496));
let _e22509 = (((_e22497 * _e647) + (_e22498 * _e660)) + (_e22499 * _e673));
let _e22514 = (((_e22494 * _e647) + (_e22495 * _e660)) + (_e22496 * _e673));
let _e22517 = ((_e22495 * _e673) - (_e22496 * _e660));
let _e22520 = ((_e22496 * _e647) - (_e22494 * _e673));
let _e22523 = ((_e22494 * _e660) - (_e22495 * _e647));
let _e22528 = (((_e22517 * _e22517) + (_e22520 * _e22520)) + (_e22523 * _e22523));
let _e22531 = (1f / select(1e-9f, _e22528, (_e22528 > 1e-9f)));
let _e22534 = ((_e22504 - (_e22514 * _e22509)) * _e22531);
let _e22537 = (((_e22514 * _e22504) - _e22509) * _e22531);
let _e22543 = select(0f, _e22534, (((_e22537 >= 0f) && (_e22537 < _e725)) && (_e22534 > 0f)));
let _e22545 = (_e22412 << bitcast<u32>(_e21887));
let _e22557 = select(((((_e21886 - select(0f, (_e21948 * _e21949), (((select(select(_e800, _e957, (_e22093 >= _e726)), _e879, (_e22093 < _e332)) == _e19560) && (_e22091 > 0f)) && (_e22091 < _e22001)))) - select(0f, (_e21945 * _e21949), (((select(select(_e800, _e957, (_e22245 >= _e726)), _e879, (_e22245 < _e332)) == _e19560) && (_e22243 > 0f)) && (_e22243 < _e22153)))) - select(0f, (_e21948 * _e21947), (((select(select(_e800, _e957, (_e22397 >= _e726)), _e879, (_e22397 < _e332)) == _e19560) && (_e22395 > 0f)) && (_e22395 < _e22305)))) - select(0f, (_e21945 * _e21947), (((select(select(_e800, _e957, (_e22545 >= _e726)), _e879, (_e22545 < _e332)) == _e19560) && (_e22543 > 0f)) && (_e22543 < _e22453)))), _e21886, _e21979);
if _e487 {
phi_29167_ = type_26(_e19667, _e19575);
} else {
phi_29167_ = type_26(_e19575, _e19667);
}
let _e22572 = phi_29167_;
let _e22575 = (_e19668 && (((_e20530 > 0f) && (_e20530 < _e19758)) && (bitcast<f32>((bitcast<u32>(_e22557) & 2147483647u)) > 1e-6f)));
let _e22578 = global_1.member.member_18.member;
let _e22579 = (((select(_e19693, (1f - _e19693), (_e19678 >= 0f)) - select(_e19712, (1f - _e19712), (_e19697 >= 0f))) * (1f / _e19675)) * _e22578);
let _e22583 = select(0f, (((((_e686 * _e20517.member) * ((1f + (_e20398 * (1f + (_e20398 * (0.5f + (_e20398 * (0.16666667f + (_e20398 * (0.041666668f + (_e20398 * (0.008333334f + (_e20398 * (0.001388889f + (_e20398 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e20393 + 127i)) << bitcast<u32>(23i))))) * _e20220) * _e22557) * _e22579), _e22575);
let _e22584 = select(0f, (((((_e699 * _e20517.member_1) * ((1f + (_e20446 * (1f + (_e20446 * (0.5f + (_e20446 * (0.16666667f + (_e20446 * (0.041666668f + (_e20446 * (0.008333334f + (_e20446 * (0.001388889f + (_e20446 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e20441 + 127i)) << bitcast<u32>(23i))))) * _e20220) * _e22557) * _e22579), _e22575);
let _e22585 = select(0f, (((((_e712 * _e20517.member_2) * ((1f + (_e20494 * (1f + (_e20494 * (0.5f + (_e20494 * (0.16666667f + (_e20494 * (0.041666668f + (_e20494 * (0.008333334f + (_e20494 * (0.001388889f + (_e20494 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e20489 + 127i)) << bitcast<u32>(23i))))) * _e20220) * _e22557) * _e22579), _e22575);
let _e22589 = (bitcast<f32>((bitcast<u32>(_e22583) & 2147483647u)) >= 1073741800f);
let _e22590 = (1f / 1048576f);
let _e22593 = ((_e22583 * select(1f, _e22590, _e22589)) + 0.5f);
let _e22595 = select(-1073741800f, _e22593, (_e22593 > -1073741800f));
let _e22597 = select(1073741800f, _e22595, (_e22595 < 1073741800f));
let _e22604 = select(0i, select(select(i32(_e22597), i32(-2147483648), (_e22597 < -2147483600f)), 2147483647i, (_e22597 > 2147483500f)), (_e22597 == _e22597));
let _e22608 = (_e22604 - select(0i, 1i, (_e22597 < f32(_e22604))));
let _e22609 = select(0i, 20i, _e22589);
let _e22613 = (bitcast<u32>(_e22608) << bitcast<u32>((_e22609 & 31i)));
let _e22620 = bitcast<u32>(((_e22608 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e22609) & 31i))));
let _e22624 = (bitcast<f32>((bitcast<u32>(_e22584) & 2147483647u)) >= 1073741800f);
let _e22627 = ((_e22584 * select(1f, _e22590, _e22624)) + 0.5f);
let _e22629 = select(-1073741800f, _e22627, (_e22627 > -1073741800f));
let _e22631 = select(1073741800f, _e22629, (_e22629 < 1073741800f));
let _e22638 = select(0i, select(select(i32(_e22631), i32(-2147483648), (_e22631 < -2147483600f)), 2147483647i, (_e22631 > 2147483500f)), (_e22631 == _e22631));
let _e22642 = (_e22638 - select(0i, 1i, (_e22631 < f32(_e22638))));
let _e22643 = select(0i, 20i, _e22624);
let _e22647 = (bitcast<u32>(_e22642) << bitcast<u32>((_e22643 & 31i)));
let _e22654 = bitcast<u32>(((_e22642 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e22643) & 31i))));
let _e22658 = (bitcast<f32>((bitcast<u32>(_e22585) & 2147483647u)) >= 1073741800f);
let _e22661 = ((_e22585 * select(1f, _e22590, _e22658)) + 0.5f);
let _e22663 = select(-1073741800f, _e22661, (_e22661 > -1073741800f));
let _e22665 = select(1073741800f, _e22663, (_e22663 < 1073741800f));
let _e22672 = select(0i, select(select(i32(_e22665), i32(-2147483648), (_e22665 < -2147483600f)), 2147483647i, (_e22665 > 2147483500f)), (_e22665 == _e22665));
let _e22676 = (_e22672 - select(0i, 1i, (_e22665 < f32(_e22672))));
let _e22677 = select(0i, 20i, _e22658);
let _e22681 = (bitcast<u32>(_e22676) << bitcast<u32>((_e22677 & 31i)));
let _e22688 = bitcast<u32>(((_e22676 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e22677) & 31i))));
let _e22693 = bitcast<i32>(bitcast<u32>((((_e22572.member_1 * _e11947) + _e22572.member) * 6i)));
if ((_e22613 | _e22620) == 0u) {
} else {
let _e22696 = bitcast<u32>(_e22693);
if (_e22696 < _e304) {
let _e22700 = atomicAdd((&global_8.member[_e22696]), _e22613);
phi_29400_ = _e22700;
} else {
phi_29400_ = 0u;
}
let _e22702 = phi_29400_;
let _e22706 = (_e22620 + select(0u, 1u, ((_e22702 + _e22613) < _e22613)));
if (_e22706 == 0u) {
} else {
let _e22708 = (_e22696 + 1u);
if (_e22708 < _e304) {
let _e22712 = atomicAdd((&global_8.member[_e22708]), _e22706);
}
}
}
if ((_e22647 | _e22654) == 0u) {
} else {
let _e22716 = bitcast<u32>((_e22693 + 2i));
if (_e22716 < _e304) {
let _e22720 = atomicAdd((&global_8.member[_e22716]), _e22647);
phi_29430_ = _e22720;
} else {
phi_29430_ = 0u;
}
let _e22722 = phi_29430_;
let _e22726 = (_e22654 + select(0u, 1u, ((_e22722 + _e22647) < _e22647)));
if (_e22726 == 0u) {
} else {
let _e22728 = (_e22716 + 1u);
if (_e22728 < _e304) {
let _e22732 = atomicAdd((&global_8.member[_e22728]), _e22726);
}
}
}
if ((_e22681 | _e22688) == 0u) {
} else {
let _e22736 = bitcast<u32>((_e22693 + 4i));
if (_e22736 < _e304) {
let _e22740 = atomicAdd((&global_8.member[_e22736]), _e22681);
phi_29460_ = _e22740;
} else {
phi_29460_ = 0u;
}
let _e22742 = phi_29460_;
let _e22746 = (_e22688 + select(0u, 1u, ((_e22742 + _e22681) < _e22681)));
if (_e22746 == 0u) {
} else {
let _e22748 = (_e22736 + 1u);
if (_e22748 < _e304) {
let _e22752 = atomicAdd((&global_8.member[_e22748]), _e22746);
}
}
}
phi_14591_ = (_e19665 + 1i);
} else {
phi_14591_ = i32();
}
let _e22755 = phi_14591_;
continue;
continuing {
phi_14590_ = _e22755;
break if !(_e19668);
}
}
phi_14437_ = (_e19572 + 1i);
} else {
phi_14437_ = i32();
}
let _e22759 = phi_14437_;
continue;
continuing {
phi_14436_ = _e22759;
break if !(_e19573);
}
}
}
}
} else {
let _e11999 = (_e800 & 31u);
let _e12001 = (1u << bitcast<u32>(_e11999));
let _e12010 = bitcast<i32>((((_e11943 + _e12001) - 1u) >> bitcast<u32>(_e11999)));
let _e12011 = bitcast<i32>((((_e11946 + _e12001) - 1u) >> bitcast<u32>(_e11999)));
if _e487 {
phi_29526_ = type_26(_e12011, _e12010);
} else {
phi_29526_ = type_26(_e12010, _e12011);
}
let _e12015 = phi_29526_;
let _e12019 = (_e11973 >> bitcast<u32>(_e11999));
if (_e12019 < _e12015.member) {
phi_29601_ = _e12019;
} else {
phi_29601_ = (_e12015.member - 1i);
}
let _e12025 = phi_29601_;
phi_29605_ = type_26(2147483647i, -1i);
phi_29608_ = 0i;
loop {
let _e12028 = phi_29605_;
let _e12030 = phi_29608_;
local_261 = _e12028;
local_262 = _e12028;
let _e12031 = (_e12030 < 16i);
if _e12031 {
let _e12033 = (1i << bitcast<u32>(_e11999));
let _e12034 = f32(_e12033);
let _e12036 = ((4u - _e800) & 31u);
let _e12041 = ((_e11991 >> bitcast<u32>(_e11999)) + (_e12030 & ((1i << bitcast<u32>(_e12036)) - 1i)));
let _e12045 = (((f32(_e12041) + 0.5f) * _e12034) - 0.5f);
let _e12049 = (-(((_e450 * _e12045) + _e476)) / _e463);
let _e12056 = bitcast<f32>((bitcast<u32>(((_e500 * _e12045) + ((_e513 * _e12049) + _e526))) & 2147483647u));
let _e12063 = bitcast<f32>((bitcast<u32>(((_e539 * _e12045) + ((_e552 * _e12049) + _e565))) & 2147483647u));
let _e12068 = (((0.5f * (_e12056 + _e12063)) / _e568) + (0.5f * _e12034));
let _e12069 = (1f / _e12034);
let _e12077 = ((((_e12049 + _e12068) + 0.5f) * _e12069) - 0.5f);
let _e12078 = f32((_e12015.member_1 - 1i));
let _e12079 = (0f - 1f);
let _e12081 = select(_e12079, _e12077, (_e12077 > _e12079));
let _e12083 = select(_e12078, _e12081, (_e12081 < _e12078));
let _e12090 = select(0i, select(select(i32(_e12083), i32(-2147483648), (_e12083 < -2147483600f)), 2147483647i, (_e12083 > 2147483500f)), (_e12083 == _e12083));
let _e12095 = (((((_e12049 - _e12068) + 0.5f) * _e12069) - 0.5f) + 1f);
let _e12096 = (_e12078 + 1f);
let _e12098 = select(0f, _e12095, (_e12095 > 0f));
let _e12100 = select(_e12096, _e12098, (_e12098 < _e12096));
let _e12107 = select(0i, select(select(i32(_e12100), i32(-2147483648), (_e12100 < -2147483600f)), 2147483647i, (_e12100 > 2147483500f)), (_e12100 == _e12100));
let _e12118 = ((1e-4f * _e12034) * _e568);
let _e12120 = select(_e12063, _e12056, (_e12056 > _e12063));
let _e12122 = select(_e12118, _e12120, (_e12120 > _e12118));
let _e12124 = select(_e12063, _e12056, (_e12056 < _e12063));
let _e12126 = select(_e12118, _e12124, (_e12124 > _e12118));
let _e12128 = (0.5f * (_e12122 + _e12126));
let _e12129 = (0.5f / _e12126);
let _e12130 = (1f / _e12122);
phi_29759_ = _e12028;
phi_29762_ = 0i;
loop {
let _e12132 = phi_29759_;
let _e12134 = phi_29762_;
local_270 = _e12132;
let _e12137 = (((_e12107 - select(0i, 1i, (_e12100 < f32(_e12107)))) + (_e12030 >> bitcast<u32>(_e12036))) + (_e12134 << bitcast<u32>(_e11999)));
let _e12138 = (_e12137 <= select(-1i, (_e12090 - select(0i, 1i, (_e12083 < f32(_e12090)))), (_e12041 <= _e12025)));
if _e12138 {
let _e12142 = (((f32(_e12137) + 0.5f) * _e12034) - 0.5f);
let _e12144 = ((_e12142 - _e12049) * _e568);
let _e12145 = (_e568 * _e12034);
let _e12147 = (0.5f * _e12145);
let _e12148 = (_e12144 + _e12147);
let _e12149 = -(_e12148);
let _e12152 = (_e12128 - select(_e12149, _e12148, (_e12148 > _e12149)));
let _e12154 = select(0f, _e12152, (_e12152 > 0f));
let _e12156 = select(_e12126, _e12154, (_e12154 < _e12126));
let _e12159 = (_e12152 - _e12126);
let _e12163 = (((_e12156 * (_e12156 * _e12129)) + select(0f, _e12159, (_e12159 > 0f))) * _e12130);
let _e12167 = (_e12144 - _e12147);
let _e12168 = -(_e12167);
let _e12171 = (_e12128 - select(_e12168, _e12167, (_e12167 > _e12168)));
let _e12173 = select(0f, _e12171, (_e12171 > 0f));
let _e12175 = select(_e12126, _e12173, (_e12173 < _e12126));
let _e12178 = (_e12171 - _e12126);
let _e12182 = (((_e12175 * (_e12175 * _e12129)) + select(0f, _e12178, (_e12178 > 0f))) * _e12130);
if _e487 {
phi_29892_ = type_26(_e12137, _e12041);
} else {
phi_29892_ = type_26(_e12041, _e12137);
}
let _e12193 = phi_29892_;
let _e12199 = bitcast<i32>(((_e11943 + 1u) >> bitcast<u32>(1u)));
let _e12202 = global_1.member.member_18.member_9;
let _e12207 = global_1.member.member_18.member_6;
let _e12210 = global_1.member.member_18.member_7;
let _e12213 = global_1.member.member_18.member_8;
if _e11998 {
phi_29943_ = 0u;
} else {
if (_e800 == 1u) {
phi_29942_ = 0u;
} else {
if (_e800 == 2u) {
phi_29941_ = _e12207;
} else {
phi_29941_ = select(_e12213, _e12210, (_e800 == 3u));
}
let _e12219 = phi_29941_;
phi_29942_ = _e12219;
}
let _e12221 = phi_29942_;
phi_29943_ = _e12221;
}
let _e12223 = phi_29943_;
local_152 = (((bitcast<i32>(_e12223) + _e12193.member_1) * _e12199) + _e12193.member);
local_153 = (_e12199 * bitcast<i32>(_e12202));
let _e12228 = local_152;
let _e12230 = (bitcast<i32>(_e296) - 1i);
let _e12232 = select(_e12230, _e12228, (_e12228 < _e12230));
let _e12237 = global_6.member[bitcast<u32>(select(0i, _e12232, (_e12232 > 0i)))];
let _e12238 = local_153;
let _e12239 = local_152;
let _e12240 = (_e12238 + _e12239);
let _e12242 = select(_e12230, _e12240, (_e12240 < _e12230));
let _e12247 = global_6.member[bitcast<u32>(select(0i, _e12242, (_e12242 > 0i)))];
let _e12248 = local_153;
let _e12250 = local_152;
let _e12251 = ((2i * _e12248) + _e12250);
let _e12253 = select(_e12230, _e12251, (_e12251 < _e12230));
let _e12258 = global_6.member[bitcast<u32>(select(0i, _e12253, (_e12253 > 0i)))];
let _e12260 = (_e12033 >> bitcast<u32>(1i));
let _e12263 = ((_e12193.member << bitcast<u32>(_e11999)) + _e12260);
let _e12266 = ((_e12193.member_1 << bitcast<u32>(_e11999)) + _e12260);
let _e12268 = select(_e12263, 0i, (_e12263 < 0i));
if (_e12268 >= _e11947) {
phi_30069_ = (_e11947 - 1i);
} else {
phi_30069_ = _e12268;
}
let _e12272 = phi_30069_;
let _e12274 = select(_e12266, 0i, (_e12266 < 0i));
if (_e12274 >= _e11948) {
phi_30080_ = (_e11948 - 1i);
} else {
phi_30080_ = _e12274;
}
let _e12278 = phi_30080_;
let _e12280 = bitcast<i32>((_e11943 * _e11946));
local_150 = _e12280;
local_151 = ((_e12278 * _e11947) + _e12272);
let _e12283 = local_150;
let _e12284 = local_151;
let _e12285 = (_e12283 + _e12284);
let _e12287 = (bitcast<i32>(_e293) - 1i);
let _e12289 = select(_e12287, _e12285, (_e12285 < _e12287));
let _e12294 = global_5.member[bitcast<u32>(select(0i, _e12289, (_e12289 > 0i)))];
let _e12295 = local_150;
let _e12297 = local_151;
let _e12298 = ((2i * _e12295) + _e12297);
let _e12300 = select(_e12287, _e12298, (_e12298 < _e12287));
let _e12305 = global_5.member[bitcast<u32>(select(0i, _e12300, (_e12300 > 0i)))];
let _e12306 = local_151;
let _e12315 = global_1.member.member_2.member;
let _e12316 = (((((select(_e12045, _e12142, _e487) + 0.5f) / f32(_e11947)) * 2f) - 1f) * _e12315);
let _e12323 = global_1.member.member_2.member_1;
let _e12324 = ((1f - (((select(_e12142, _e12045, _e487) + 0.5f) / f32(_e11948)) * 2f)) * _e12323);
let _e12326 = global_1.member.member_3;
let _e12334 = global_1.member.member_4;
let _e12341 = ((_e12326.member * _e12316) + (_e12334.member * _e12324));
let _e12342 = ((_e12326.member_1 * _e12316) + (_e12334.member_1 * _e12324));
let _e12343 = ((_e12326.member_2 * _e12316) + (_e12334.member_2 * _e12324));
let _e12346 = global_1.member.member_2.member_3;
let _e12347 = (_e12346 != 0u);
let _e12349 = global_1.member.member_5;
let _e12356 = select((_e12349.member + _e12341), _e12349.member, _e12347);
let _e12357 = select((_e12349.member_1 + _e12342), _e12349.member_1, _e12347);
let _e12358 = select((_e12349.member_2 + _e12343), _e12349.member_2, _e12347);
let _e12360 = global_1.member.member_6;
let _e12367 = select(_e12360.member, (_e12360.member + _e12341), _e12347);
let _e12368 = select(_e12360.member_1, (_e12360.member_1 + _e12342), _e12347);
let _e12369 = select(_e12360.member_2, (_e12360.member_2 + _e12343), _e12347);
let _e12374 = (((_e12356 * _e12356) + (_e12357 * _e12357)) + (_e12358 * _e12358));
let _e12377 = sqrt(select(0f, _e12374, (_e12374 > 0f)));
let _e12378 = (1f / _e12377);
let _e12379 = (_e12356 * _e12378);
let _e12380 = (_e12357 * _e12378);
let _e12381 = (_e12358 * _e12378);
let _e12382 = (_e609 - _e12367);
let _e12383 = (_e621 - _e12368);
let _e12384 = (_e634 - _e12369);
let _e12389 = (((_e12382 * _e12379) + (_e12383 * _e12380)) + (_e12384 * _e12381));
let _e12394 = (((_e12382 * _e647) + (_e12383 * _e660)) + (_e12384 * _e673));
let _e12399 = (((_e12379 * _e647) + (_e12380 * _e660)) + (_e12381 * _e673));
let _e12402 = ((_e12380 * _e673) - (_e12381 * _e660));
let _e12405 = ((_e12381 * _e647) - (_e12379 * _e673));
let _e12408 = ((_e12379 * _e660) - (_e12380 * _e647));
let _e12413 = (((_e12402 * _e12402) + (_e12405 * _e12405)) + (_e12408 * _e12408));
let _e12416 = (1f / select(1e-9f, _e12413, (_e12413 > 1e-9f)));
let _e12419 = ((_e12389 - (_e12399 * _e12394)) * _e12416);
let _e12422 = (((_e12399 * _e12389) - _e12394) * _e12416);
let _e12428 = -(_e12399);
let _e12431 = global_1.member.member_13.member_2;
let _e12432 = (_e12431 * _e12431);
let _e12436 = ((1f + _e12432) - ((2f * _e12431) * _e12428));
let _e12438 = select(1e-9f, _e12436, (_e12436 > 1e-9f));
let _e12450 = global_1.member.member_13.member_3;
if (_e12450 == 2u) {
let _e12455 = (0.5f - (0.5f * _e12428));
let _e12457 = select(0f, _e12455, (_e12455 > 0f));
let _e12461 = (sqrt(select(0f, _e12457, (_e12457 > 0f))) * 255f);
let _e12462 = (255f - 1f);
let _e12464 = select(0f, _e12461, (_e12461 > 0f));
let _e12466 = select(_e12462, _e12464, (_e12464 < _e12462));
let _e12473 = select(0i, select(select(i32(_e12466), i32(-2147483648), (_e12466 < -2147483600f)), 2147483647i, (_e12466 > 2147483500f)), (_e12466 == _e12466));
let _e12477 = (_e12473 - select(0i, 1i, (_e12466 < f32(_e12473))));
let _e12480 = global_1.member.member_13.member_11;
let _e12481 = bitcast<i32>(_e12480);
let _e12482 = (_e12481 + _e12477);
let _e12484 = (bitcast<i32>(_e299) - 1i);
let _e12486 = select(_e12484, _e12482, (_e12482 < _e12484));
let _e12491 = global_2.member[bitcast<u32>(select(0i, _e12486, (_e12486 > 0i)))];
let _e12493 = (_e12481 + (_e12477 + 1i));
let _e12495 = select(_e12484, _e12493, (_e12493 < _e12484));
let _e12500 = global_2.member[bitcast<u32>(select(0i, _e12495, (_e12495 > 0i)))];
phi_30503_ = (_e12491 + ((_e12500 - _e12491) * (_e12461 - f32(_e12477))));
} else {
phi_30503_ = select(((1f - _e12432) / (_e12438 * sqrt(select(0f, _e12438, (_e12438 > 0f))))), (0.75f * (1f + (_e12428 * _e12428))), (_e12450 == 1u));
}
let _e12507 = phi_30503_;
let _e12519 = global_1.member.member_13.member_7;
let _e12520 = bitcast<i32>(_e12519);
let _e12523 = global_1.member.member_13.member_8;
let _e12524 = bitcast<i32>(_e12523);
let _e12527 = global_1.member.member_13.member_9;
let _e12528 = bitcast<i32>(_e12527);
let _e12531 = global_1.member.member_13.member_4;
let _e12537 = global_1.member.member_13.member_5;
let _e12541 = f32(_e12520);
let _e12546 = (((((_e12367 + (_e12379 * _e12419)) - _e12531.member) / (_e12537.member - _e12531.member)) * _e12541) - 0.5f);
let _e12547 = (_e12541 - 1f);
let _e12549 = select(0f, _e12546, (_e12546 > 0f));
let _e12551 = select(_e12547, _e12549, (_e12549 < _e12547));
let _e12552 = f32(_e12524);
let _e12557 = (((((_e12368 + (_e12380 * _e12419)) - _e12531.member_1) / (_e12537.member_1 - _e12531.member_1)) * _e12552) - 0.5f);
let _e12558 = (_e12552 - 1f);
let _e12560 = select(0f, _e12557, (_e12557 > 0f));
let _e12562 = select(_e12558, _e12560, (_e12560 < _e12558));
let _e12563 = f32(_e12528);
let _e12568 = (((((_e12369 + (_e12381 * _e12419)) - _e12531.member_2) / (_e12537.member_2 - _e12531.member_2)) * _e12563) - 0.5f);
let _e12569 = (_e12563 - 1f);
let _e12571 = select(0f, _e12568, (_e12568 > 0f));
let _e12573 = select(_e12569, _e12571, (_e12571 < _e12569));
let _e12575 = select(0f, _e12551, (_e12551 > 0f));
let _e12577 = select(1e6f, _e12575, (_e12575 < 1e6f));
let _e12584 = select(0i, select(select(i32(_e12577), i32(-2147483648), (_e12577 < -2147483600f)), 2147483647i, (_e12577 > 2147483500f)), (_e12577 == _e12577));
let _e12588 = (_e12584 - select(0i, 1i, (_e12577 < f32(_e12584))));
let _e12590 = select(0f, _e12562, (_e12562 > 0f));
let _e12592 = select(1e6f, _e12590, (_e12590 < 1e6f));
let _e12599 = select(0i, select(select(i32(_e12592), i32(-2147483648), (_e12592 < -2147483600f)), 2147483647i, (_e12592 > 2147483500f)), (_e12592 == _e12592));
let _e12603 = (_e12599 - select(0i, 1i, (_e12592 < f32(_e12599))));
let _e12605 = select(0f, _e12573, (_e12573 > 0f));
let _e12607 = select(1e6f, _e12605, (_e12605 < 1e6f));
let _e12614 = select(0i, select(select(i32(_e12607), i32(-2147483648), (_e12607 < -2147483600f)), 2147483647i, (_e12607 > 2147483500f)), (_e12607 == _e12607));
let _e12618 = (_e12614 - select(0i, 1i, (_e12607 < f32(_e12614))));
let _e12622 = (_e12562 - f32(_e12603));
let _e12624 = (_e12573 - f32(_e12618));
local_148 = (_e12551 - f32(_e12588));
let _e12625 = (_e12588 + 1i);
let _e12627 = select(_e12625, 0i, (_e12625 < 0i));
if (_e12627 >= _e12520) {
phi_30635_ = (_e12520 - 1i);
} else {
phi_30635_ = _e12627;
}
let _e12631 = phi_30635_;
local_149 = (_e12631 - _e12588);
let _e12633 = (_e12603 + 1i);
let _e12635 = select(_e12633, 0i, (_e12633 < 0i));
if (_e12635 >= _e12524) {
phi_30648_ = (_e12524 - 1i);
} else {
phi_30648_ = _e12635;
}
let _e12639 = phi_30648_;
let _e12641 = ((_e12639 - _e12603) * _e12520);
let _e12642 = (_e12618 + 1i);
let _e12644 = select(_e12642, 0i, (_e12642 < 0i));
if (_e12644 >= _e12528) {
phi_30662_ = (_e12528 - 1i);
} else {
phi_30662_ = _e12644;
}
let _e12648 = phi_30662_;
let _e12654 = global_1.member.member_13.member_10;
let _e12660 = ((bitcast<i32>(_e12654) + (((_e12618 * _e12524) + _e12603) * _e12520)) + _e12588);
let _e12662 = (bitcast<i32>(_e299) - 1i);
let _e12664 = select(_e12662, _e12660, (_e12660 < _e12662));
let _e12669 = global_2.member[bitcast<u32>(select(0i, _e12664, (_e12664 > 0i)))];
let _e12670 = local_148;
let _e12673 = local_149;
let _e12674 = (_e12660 + _e12673);
let _e12676 = select(_e12662, _e12674, (_e12674 < _e12662));
let _e12681 = global_2.member[bitcast<u32>(select(0i, _e12676, (_e12676 > 0i)))];
let _e12682 = local_148;
let _e12685 = (1f - _e12622);
let _e12687 = (_e12660 + _e12641);
let _e12689 = select(_e12662, _e12687, (_e12687 < _e12662));
let _e12694 = global_2.member[bitcast<u32>(select(0i, _e12689, (_e12689 > 0i)))];
let _e12695 = local_148;
let _e12698 = local_149;
let _e12699 = (_e12687 + _e12698);
let _e12701 = select(_e12662, _e12699, (_e12699 < _e12662));
let _e12706 = global_2.member[bitcast<u32>(select(0i, _e12701, (_e12701 > 0i)))];
let _e12707 = local_148;
let _e12712 = (_e12660 + (((_e12648 - _e12618) * _e12520) * _e12524));
let _e12714 = select(_e12662, _e12712, (_e12712 < _e12662));
let _e12719 = global_2.member[bitcast<u32>(select(0i, _e12714, (_e12714 > 0i)))];
let _e12720 = local_148;
let _e12723 = local_149;
let _e12724 = (_e12712 + _e12723);
let _e12726 = select(_e12662, _e12724, (_e12724 < _e12662));
let _e12731 = global_2.member[bitcast<u32>(select(0i, _e12726, (_e12726 > 0i)))];
let _e12732 = local_148;
let _e12736 = (_e12712 + _e12641);
let _e12738 = select(_e12662, _e12736, (_e12736 < _e12662));
let _e12743 = global_2.member[bitcast<u32>(select(0i, _e12738, (_e12738 > 0i)))];
let _e12744 = local_148;
let _e12747 = local_149;
let _e12748 = (_e12736 + _e12747);
let _e12750 = select(_e12662, _e12748, (_e12748 < _e12662));
let _e12755 = global_2.member[bitcast<u32>(select(0i, _e12750, (_e12750 > 0i)))];
let _e12756 = local_148;
let _e12765 = ((_e12377 * (_e12507 * (0.25f / 3.1415927f))) * ((((((_e12669 * (1f - _e12670)) + (_e12681 * _e12682)) * _e12685) + (((_e12694 * (1f - _e12695)) + (_e12706 * _e12707)) * _e12622)) * (1f - _e12624)) + (((((_e12719 * (1f - _e12720)) + (_e12731 * _e12732)) * _e12685) + (((_e12743 * (1f - _e12744)) + (_e12755 * _e12756)) * _e12622)) * _e12624)));
let _e12768 = global_1.member.member_12.member_12;
let _e12771 = global_1.member.member_12.member_4;
let _e12774 = global_1.member.member_12.member_13;
let _e12780 = global_1.member.member.member;
let _e12782 = (_e12422 / _e725);
local_145 = bitcast<i32>((_e12768 + (_e12771 * _e12774)));
local_146 = _e315;
local_147 = bitcast<i32>(_e12780);
let _e12785 = global_1.member.member_13.member_6;
let _e12786 = f32(_e12785);
let _e12788 = select(0f, _e12782, (_e12782 > 0f));
let _e12791 = (select(1f, _e12788, (_e12788 < 1f)) * _e12786);
let _e12792 = (_e12786 - 1f);
let _e12794 = select(0f, _e12792, (_e12792 > 0f));
let _e12796 = select(0f, _e12791, (_e12791 > 0f));
let _e12798 = select(_e12794, _e12796, (_e12796 < _e12794));
let _e12805 = select(0i, select(select(i32(_e12798), i32(-2147483648), (_e12798 < -2147483600f)), 2147483647i, (_e12798 > 2147483500f)), (_e12798 == _e12798));
let _e12809 = (_e12805 - select(0i, 1i, (_e12798 < f32(_e12805))));
if (_e12809 > 0i) {
let _e12812 = local_145;
let _e12813 = local_147;
let _e12816 = local_146;
let _e12817 = ((_e12812 + ((_e12809 - 1i) * _e12813)) + _e12816);
let _e12819 = (bitcast<i32>(_e302) - 1i);
let _e12821 = select(_e12819, _e12817, (_e12817 < _e12819));
let _e12826 = global_7.member[bitcast<u32>(select(0i, _e12821, (_e12821 > 0i)))];
phi_30966_ = _e12826;
} else {
phi_30966_ = 0f;
}
let _e12828 = phi_30966_;
let _e12829 = local_145;
let _e12830 = local_147;
let _e12833 = local_146;
let _e12834 = ((_e12829 + (_e12809 * _e12830)) + _e12833);
let _e12836 = (bitcast<i32>(_e302) - 1i);
let _e12838 = select(_e12836, _e12834, (_e12834 < _e12836));
let _e12843 = global_7.member[bitcast<u32>(select(0i, _e12838, (_e12838 > 0i)))];
let _e12850 = (_e12305 - _e12294);
let _e12853 = ((_e12419 - _e12294) / select(1e-9f, _e12850, (_e12850 > 1e-9f)));
local_142 = 0i;
local_143 = _e12306;
local_144 = _e12280;
let _e12855 = select(0f, _e12853, (_e12853 > 0f));
let _e12858 = (select(1f, _e12855, (_e12855 < 1f)) * _e12786);
let _e12860 = select(0f, _e12858, (_e12858 > 0f));
let _e12862 = select(_e12794, _e12860, (_e12860 < _e12794));
let _e12869 = select(0i, select(select(i32(_e12862), i32(-2147483648), (_e12862 < -2147483600f)), 2147483647i, (_e12862 > 2147483500f)), (_e12862 == _e12862));
let _e12873 = (_e12869 - select(0i, 1i, (_e12862 < f32(_e12869))));
if (_e12873 > 0i) {
let _e12876 = local_142;
let _e12877 = local_144;
let _e12880 = local_143;
let _e12881 = ((_e12876 + ((_e12873 - 1i) * _e12877)) + _e12880);
let _e12883 = select(_e12836, _e12881, (_e12881 < _e12836));
let _e12888 = global_7.member[bitcast<u32>(select(0i, _e12883, (_e12883 > 0i)))];
phi_31093_ = _e12888;
} else {
phi_31093_ = 0f;
}
let _e12890 = phi_31093_;
let _e12891 = local_142;
let _e12892 = local_144;
let _e12895 = local_143;
let _e12896 = ((_e12891 + (_e12873 * _e12892)) + _e12895);
let _e12898 = select(_e12836, _e12896, (_e12896 < _e12836));
let _e12903 = global_7.member[bitcast<u32>(select(0i, _e12898, (_e12898 > 0i)))];
let _e12909 = ((_e12828 + ((_e12843 - _e12828) * (_e12791 - f32(_e12809)))) + (_e12890 + ((_e12903 - _e12890) * (_e12858 - f32(_e12873)))));
let _e12912 = global_1.member.member_13.member;
let _e12917 = -((_e12912.member * _e12909));
let _e12919 = select(-87f, _e12917, (_e12917 > -87f));
let _e12921 = select(88f, _e12919, (_e12919 < 88f));
let _e12923 = ((_e12921 * 1.442695f) + 0.5f);
let _e12925 = select(-127f, _e12923, (_e12923 > -127f));
let _e12927 = select(128f, _e12925, (_e12925 < 128f));
let _e12934 = select(0i, select(select(i32(_e12927), i32(-2147483648), (_e12927 < -2147483600f)), 2147483647i, (_e12927 > 2147483500f)), (_e12927 == _e12927));
let _e12938 = (_e12934 - select(0i, 1i, (_e12927 < f32(_e12934))));
let _e12939 = f32(_e12938);
let _e12943 = ((_e12921 - (_e12939 * 0.6933594f)) - (_e12939 * -2.1219444e-4f));
let _e12965 = -((_e12912.member_1 * _e12909));
let _e12967 = select(-87f, _e12965, (_e12965 > -87f));
let _e12969 = select(88f, _e12967, (_e12967 < 88f));
let _e12971 = ((_e12969 * 1.442695f) + 0.5f);
let _e12973 = select(-127f, _e12971, (_e12971 > -127f));
let _e12975 = select(128f, _e12973, (_e12973 < 128f));
let _e12982 = select(0i, select(select(i32(_e12975), i32(-2147483648), (_e12975 < -2147483600f)), 2147483647i, (_e12975 > 2147483500f)), (_e12975 == _e12975));
let _e12986 = (_e12982 - select(0i, 1i, (_e12975 < f32(_e12982))));
let _e12987 = f32(_e12986);
let _e12991 = ((_e12969 - (_e12987 * 0.6933594f)) - (_e12987 * -2.1219444e-4f));
let _e13013 = -((_e12912.member_2 * _e12909));
let _e13015 = select(-87f, _e13013, (_e13013 > -87f));
let _e13017 = select(88f, _e13015, (_e13015 < 88f));
let _e13019 = ((_e13017 * 1.442695f) + 0.5f);
let _e13021 = select(-127f, _e13019, (_e13019 > -127f));
let _e13023 = select(128f, _e13021, (_e13021 < 128f));
let _e13030 = select(0i, select(select(i32(_e13023), i32(-2147483648), (_e13023 < -2147483600f)), 2147483647i, (_e13023 > 2147483500f)), (_e13023 == _e13023));
let _e13034 = (_e13030 - select(0i, 1i, (_e13023 < f32(_e13030))));
let _e13035 = f32(_e13034);
let _e13039 = ((_e13017 - (_e13035 * 0.6933594f)) - (_e13035 * -2.1219444e-4f));
let _e13062 = global_1.member.member_13.member_1;
let _e13075 = select(0f, _e12419, (((_e12422 >= 0f) && (_e12422 < _e725)) && (_e12419 > 0f)));
let _e13078 = ((_e13075 > 0f) && (_e13075 < _e12237));
if _e487 {
phi_31378_ = type_26(_e12137, _e12041);
} else {
phi_31378_ = type_26(_e12041, _e12137);
}
let _e13102 = phi_31378_;
let _e13105 = (_e12138 && _e13078);
let _e13108 = global_1.member.member_18.member;
let _e13109 = (((select(_e12163, (1f - _e12163), (_e12148 >= 0f)) - select(_e12182, (1f - _e12182), (_e12167 >= 0f))) * (1f / _e12145)) * _e13108);
let _e13113 = select(0f, ((((_e686 * _e13062.member) * ((1f + (_e12943 * (1f + (_e12943 * (0.5f + (_e12943 * (0.16666667f + (_e12943 * (0.041666668f + (_e12943 * (0.008333334f + (_e12943 * (0.001388889f + (_e12943 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e12938 + 127i)) << bitcast<u32>(23i))))) * _e12765) * _e13109), _e13105);
let _e13114 = select(0f, ((((_e699 * _e13062.member_1) * ((1f + (_e12991 * (1f + (_e12991 * (0.5f + (_e12991 * (0.16666667f + (_e12991 * (0.041666668f + (_e12991 * (0.008333334f + (_e12991 * (0.001388889f + (_e12991 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e12986 + 127i)) << bitcast<u32>(23i))))) * _e12765) * _e13109), _e13105);
let _e13115 = select(0f, ((((_e712 * _e13062.member_2) * ((1f + (_e13039 * (1f + (_e13039 * (0.5f + (_e13039 * (0.16666667f + (_e13039 * (0.041666668f + (_e13039 * (0.008333334f + (_e13039 * (0.001388889f + (_e13039 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e13034 + 127i)) << bitcast<u32>(23i))))) * _e12765) * _e13109), _e13105);
let _e13119 = (bitcast<f32>((bitcast<u32>(_e13113) & 2147483647u)) >= 1073741800f);
let _e13120 = (1f / 1048576f);
let _e13123 = ((_e13113 * select(1f, _e13120, _e13119)) + 0.5f);
let _e13125 = select(-1073741800f, _e13123, (_e13123 > -1073741800f));
let _e13127 = select(1073741800f, _e13125, (_e13125 < 1073741800f));
let _e13134 = select(0i, select(select(i32(_e13127), i32(-2147483648), (_e13127 < -2147483600f)), 2147483647i, (_e13127 > 2147483500f)), (_e13127 == _e13127));
let _e13138 = (_e13134 - select(0i, 1i, (_e13127 < f32(_e13134))));
let _e13139 = select(0i, 20i, _e13119);
let _e13143 = (bitcast<u32>(_e13138) << bitcast<u32>((_e13139 & 31i)));
let _e13150 = bitcast<u32>(((_e13138 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e13139) & 31i))));
let _e13154 = (bitcast<f32>((bitcast<u32>(_e13114) & 2147483647u)) >= 1073741800f);
let _e13157 = ((_e13114 * select(1f, _e13120, _e13154)) + 0.5f);
let _e13159 = select(-1073741800f, _e13157, (_e13157 > -1073741800f));
let _e13161 = select(1073741800f, _e13159, (_e13159 < 1073741800f));
let _e13168 = select(0i, select(select(i32(_e13161), i32(-2147483648), (_e13161 < -2147483600f)), 2147483647i, (_e13161 > 2147483500f)), (_e13161 == _e13161));
let _e13172 = (_e13168 - select(0i, 1i, (_e13161 < f32(_e13168))));
let _e13173 = select(0i, 20i, _e13154);
let _e13177 = (bitcast<u32>(_e13172) << bitcast<u32>((_e13173 & 31i)));
let _e13184 = bitcast<u32>(((_e13172 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e13173) & 31i))));
let _e13188 = (bitcast<f32>((bitcast<u32>(_e13115) & 2147483647u)) >= 1073741800f);
let _e13191 = ((_e13115 * select(1f, _e13120, _e13188)) + 0.5f);
let _e13193 = select(-1073741800f, _e13191, (_e13191 > -1073741800f));
let _e13195 = select(1073741800f, _e13193, (_e13193 < 1073741800f));
let _e13202 = select(0i, select(select(i32(_e13195), i32(-2147483648), (_e13195 < -2147483600f)), 2147483647i, (_e13195 > 2147483500f)), (_e13195 == _e13195));
let _e13206 = (_e13202 - select(0i, 1i, (_e13195 < f32(_e13202))));
let _e13207 = select(0i, 20i, _e13188);
let _e13211 = (bitcast<u32>(_e13206) << bitcast<u32>((_e13207 & 31i)));
let _e13218 = bitcast<u32>(((_e13206 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e13207) & 31i))));
let _e13223 = global_1.member.member_18.member_2;
let _e13226 = global_1.member.member_18.member_3;
let _e13229 = global_1.member.member_18.member_4;
let _e13232 = global_1.member.member_18.member_5;
if _e11998 {
phi_31577_ = 0u;
} else {
if (_e800 == 1u) {
phi_31576_ = _e13223;
} else {
if (_e800 == 2u) {
phi_31575_ = _e13226;
} else {
phi_31575_ = select(_e13232, _e13229, (_e800 == 3u));
}
let _e13238 = phi_31575_;
phi_31576_ = _e13238;
}
let _e13240 = phi_31576_;
phi_31577_ = _e13240;
}
let _e13242 = phi_31577_;
let _e13250 = bitcast<i32>(bitcast<u32>((((bitcast<i32>(_e13242) + (_e13102.member_1 * _e12010)) + _e13102.member) * 6i)));
if ((_e13143 | _e13150) == 0u) {
} else {
let _e13253 = bitcast<u32>(_e13250);
if (_e13253 < _e304) {
let _e13257 = atomicAdd((&global_8.member[_e13253]), _e13143);
phi_31611_ = _e13257;
} else {
phi_31611_ = 0u;
}
let _e13259 = phi_31611_;
let _e13263 = (_e13150 + select(0u, 1u, ((_e13259 + _e13143) < _e13143)));
if (_e13263 == 0u) {
} else {
let _e13265 = (_e13253 + 1u);
if (_e13265 < _e304) {
let _e13269 = atomicAdd((&global_8.member[_e13265]), _e13263);
}
}
}
if ((_e13177 | _e13184) == 0u) {
} else {
let _e13273 = bitcast<u32>((_e13250 + 2i));
if (_e13273 < _e304) {
let _e13277 = atomicAdd((&global_8.member[_e13273]), _e13177);
phi_31641_ = _e13277;
} else {
phi_31641_ = 0u;
}
let _e13279 = phi_31641_;
let _e13283 = (_e13184 + select(0u, 1u, ((_e13279 + _e13177) < _e13177)));
if (_e13283 == 0u) {
} else {
let _e13285 = (_e13273 + 1u);
if (_e13285 < _e304) {
let _e13289 = atomicAdd((&global_8.member[_e13285]), _e13283);
}
}
}
if ((_e13211 | _e13218) == 0u) {
} else {
let _e13293 = bitcast<u32>((_e13250 + 4i));
if (_e13293 < _e304) {
let _e13297 = atomicAdd((&global_8.member[_e13293]), _e13211);
phi_31671_ = _e13297;
} else {
phi_31671_ = 0u;
}
let _e13299 = phi_31671_;
let _e13303 = (_e13218 + select(0u, 1u, ((_e13299 + _e13211) < _e13211)));
if (_e13303 == 0u) {
} else {
let _e13305 = (_e13293 + 1u);
if (_e13305 < _e304) {
let _e13309 = atomicAdd((&global_8.member[_e13305]), _e13303);
}
}
}
let _e13310 = bitcast<i32>(bitcast<u32>(select(-1i, _e12137, (_e12138 && (!(((_e13078 && !(((((_e12041 * _e12033) == _e332) && (_e879 != _e800)) || ((((_e12041 + 1i) * _e12033) == _e726) && (_e957 != _e800))))) && ((_e13075 * (1f + (0.02f * _e12034))) < _e12258))) && (_e13075 <= _e12247))))));
if (_e13310 >= 0i) {
phi_31708_ = type_26(select(_e12132.member, _e13310, (_e13310 < _e12132.member)), select(_e12132.member_1, _e13310, (_e13310 > _e12132.member_1)));
} else {
phi_31708_ = _e12132;
}
let _e13320 = phi_31708_;
phi_29760_ = _e13320;
phi_29763_ = (_e12134 + 1i);
} else {
phi_29760_ = type_26();
phi_29763_ = i32();
}
let _e13323 = phi_29760_;
let _e13325 = phi_29763_;
continue;
continuing {
phi_29759_ = _e13323;
phi_29762_ = _e13325;
break if !(_e12138);
}
}
let _e28574 = local_270;
phi_29606_ = _e28574;
phi_29609_ = (_e12030 + 1i);
} else {
phi_29606_ = type_26();
phi_29609_ = i32();
}
let _e13329 = phi_29606_;
let _e13331 = phi_29609_;
continue;
continuing {
phi_29605_ = _e13329;
phi_29608_ = _e13331;
break if !(_e12031);
}
}
let _e13334 = local_261;
let _e13337 = local_262;
if (_e13334.member <= _e13337.member_1) {
let _e13342 = ((_e13337.member_1 + 1i) << bitcast<u32>(_e11999));
if (_e13342 <= _e11997) {
phi_31725_ = (_e13342 - 1i);
} else {
phi_31725_ = _e11997;
}
let _e13346 = phi_31725_;
let _e13348 = (_e13334.member << bitcast<u32>(_e11999));
let _e13350 = select(_e879, 0u, (_e879 == _e800));
let _e13354 = select(_e957, 0u, ((_e957 == _e800) || (_e957 == _e879)));
let _e13362 = ((select(0u, 1u, (_e800 > 0u)) + select(0u, 1u, (_e13350 > 0u))) + select(0u, 1u, (_e13354 > 0u)));
if (_e13362 == 0u) {
phi_31760_ = 0i;
loop {
let _e18396 = phi_31760_;
let _e18397 = (_e18396 < 16i);
if _e18397 {
let _e18399 = (_e11992 + (_e18396 & 15i));
let _e18403 = (((f32(_e18399) + 0.5f) * 1f) - 0.5f);
let _e18407 = (-(((_e450 * _e18403) + _e476)) / _e463);
let _e18414 = bitcast<f32>((bitcast<u32>(((_e500 * _e18403) + ((_e513 * _e18407) + _e526))) & 2147483647u));
let _e18421 = bitcast<f32>((bitcast<u32>(((_e539 * _e18403) + ((_e552 * _e18407) + _e565))) & 2147483647u));
let _e18425 = (((0.5f * (_e18414 + _e18421)) / _e568) + _e751);
let _e18426 = (1f / 1f);
let _e18434 = ((((_e18407 + _e18425) + 0.5f) * _e18426) - 0.5f);
let _e18435 = f32(_e13348);
let _e18436 = f32(_e13346);
let _e18437 = (_e18435 - 1f);
let _e18439 = select(_e18437, _e18434, (_e18434 > _e18437));
let _e18441 = select(_e18436, _e18439, (_e18439 < _e18436));
let _e18448 = select(0i, select(select(i32(_e18441), i32(-2147483648), (_e18441 < -2147483600f)), 2147483647i, (_e18441 > 2147483500f)), (_e18441 == _e18441));
let _e18453 = (((((_e18407 - _e18425) + 0.5f) * _e18426) - 0.5f) + 1f);
let _e18454 = (_e18436 + 1f);
let _e18456 = select(_e18435, _e18453, (_e18453 > _e18435));
let _e18458 = select(_e18454, _e18456, (_e18456 < _e18454));
let _e18465 = select(0i, select(select(i32(_e18458), i32(-2147483648), (_e18458 < -2147483600f)), 2147483647i, (_e18458 > 2147483500f)), (_e18458 == _e18458));
let _e18476 = ((1e-4f * 1f) * _e568);
let _e18478 = select(_e18421, _e18414, (_e18414 > _e18421));
let _e18480 = select(_e18476, _e18478, (_e18478 > _e18476));
let _e18482 = select(_e18421, _e18414, (_e18414 < _e18421));
let _e18484 = select(_e18476, _e18482, (_e18482 > _e18476));
let _e18486 = (0.5f * (_e18480 + _e18484));
let _e18487 = (0.5f / _e18484);
let _e18488 = (1f / _e18480);
phi_31914_ = 0i;
loop {
let _e18490 = phi_31914_;
let _e18492 = (((_e18465 - select(0i, 1i, (_e18458 < f32(_e18465)))) + (_e18396 >> bitcast<u32>(4u))) + bitcast<i32>(_e18490));
let _e18493 = (_e18492 <= select(-1i, (_e18448 - select(0i, 1i, (_e18441 < f32(_e18448)))), (_e18399 <= _e11996)));
if _e18493 {
let _e18499 = (((((f32(_e18492) + 0.5f) * 1f) - 0.5f) - _e18407) * _e568);
let _e18500 = (_e568 * 1f);
let _e18502 = (0.5f * _e18500);
let _e18503 = (_e18499 + _e18502);
let _e18504 = -(_e18503);
let _e18507 = (_e18486 - select(_e18504, _e18503, (_e18503 > _e18504)));
let _e18509 = select(0f, _e18507, (_e18507 > 0f));
let _e18511 = select(_e18484, _e18509, (_e18509 < _e18484));
let _e18514 = (_e18507 - _e18484);
let _e18518 = (((_e18511 * (_e18511 * _e18487)) + select(0f, _e18514, (_e18514 > 0f))) * _e18488);
let _e18522 = (_e18499 - _e18502);
let _e18523 = -(_e18522);
let _e18526 = (_e18486 - select(_e18523, _e18522, (_e18522 > _e18523)));
let _e18528 = select(0f, _e18526, (_e18526 > 0f));
let _e18530 = select(_e18484, _e18528, (_e18528 < _e18484));
let _e18533 = (_e18526 - _e18484);
let _e18537 = (((_e18530 * (_e18530 * _e18487)) + select(0f, _e18533, (_e18533 > 0f))) * _e18488);
if _e487 {
phi_32019_ = type_26(_e18492, _e18399);
} else {
phi_32019_ = type_26(_e18399, _e18492);
}
let _e18546 = phi_32019_;
let _e18550 = bitcast<i32>((_e11943 * _e11946));
local_140 = _e18550;
local_141 = ((_e18546.member_1 * _e11947) + _e18546.member);
let _e18553 = local_140;
let _e18554 = local_141;
let _e18555 = (_e18553 + _e18554);
let _e18557 = (bitcast<i32>(_e293) - 1i);
let _e18559 = select(_e18557, _e18555, (_e18555 < _e18557));
let _e18564 = global_5.member[bitcast<u32>(select(0i, _e18559, (_e18559 > 0i)))];
let _e18565 = local_140;
let _e18567 = local_141;
let _e18568 = ((2i * _e18565) + _e18567);
let _e18570 = select(_e18557, _e18568, (_e18568 < _e18557));
let _e18575 = global_5.member[bitcast<u32>(select(0i, _e18570, (_e18570 > 0i)))];
let _e18576 = local_141;
let _e18578 = select(_e18557, _e18576, (_e18576 < _e18557));
let _e18583 = global_5.member[bitcast<u32>(select(0i, _e18578, (_e18578 > 0i)))];
let _e18584 = local_141;
let _e18595 = global_1.member.member_2.member;
let _e18596 = (((((f32(_e18546.member) + 0.5f) / f32(_e11947)) * 2f) - 1f) * _e18595);
let _e18603 = global_1.member.member_2.member_1;
let _e18604 = ((1f - (((f32(_e18546.member_1) + 0.5f) / f32(_e11948)) * 2f)) * _e18603);
let _e18606 = global_1.member.member_3;
let _e18614 = global_1.member.member_4;
let _e18621 = ((_e18606.member * _e18596) + (_e18614.member * _e18604));
let _e18622 = ((_e18606.member_1 * _e18596) + (_e18614.member_1 * _e18604));
let _e18623 = ((_e18606.member_2 * _e18596) + (_e18614.member_2 * _e18604));
let _e18626 = global_1.member.member_2.member_3;
let _e18627 = (_e18626 != 0u);
let _e18629 = global_1.member.member_5;
let _e18636 = select((_e18629.member + _e18621), _e18629.member, _e18627);
let _e18637 = select((_e18629.member_1 + _e18622), _e18629.member_1, _e18627);
let _e18638 = select((_e18629.member_2 + _e18623), _e18629.member_2, _e18627);
let _e18640 = global_1.member.member_6;
let _e18647 = select(_e18640.member, (_e18640.member + _e18621), _e18627);
let _e18648 = select(_e18640.member_1, (_e18640.member_1 + _e18622), _e18627);
let _e18649 = select(_e18640.member_2, (_e18640.member_2 + _e18623), _e18627);
let _e18654 = (((_e18636 * _e18636) + (_e18637 * _e18637)) + (_e18638 * _e18638));
let _e18657 = sqrt(select(0f, _e18654, (_e18654 > 0f)));
let _e18658 = (1f / _e18657);
let _e18659 = (_e18636 * _e18658);
let _e18660 = (_e18637 * _e18658);
let _e18661 = (_e18638 * _e18658);
let _e18662 = (_e609 - _e18647);
let _e18663 = (_e621 - _e18648);
let _e18664 = (_e634 - _e18649);
let _e18669 = (((_e18662 * _e18659) + (_e18663 * _e18660)) + (_e18664 * _e18661));
let _e18674 = (((_e18662 * _e647) + (_e18663 * _e660)) + (_e18664 * _e673));
let _e18679 = (((_e18659 * _e647) + (_e18660 * _e660)) + (_e18661 * _e673));
let _e18682 = ((_e18660 * _e673) - (_e18661 * _e660));
let _e18685 = ((_e18661 * _e647) - (_e18659 * _e673));
let _e18688 = ((_e18659 * _e660) - (_e18660 * _e647));
let _e18693 = (((_e18682 * _e18682) + (_e18685 * _e18685)) + (_e18688 * _e18688));
let _e18696 = (1f / select(1e-9f, _e18693, (_e18693 > 1e-9f)));
let _e18699 = ((_e18669 - (_e18679 * _e18674)) * _e18696);
let _e18702 = (((_e18679 * _e18669) - _e18674) * _e18696);
let _e18708 = -(_e18679);
let _e18711 = global_1.member.member_13.member_2;
let _e18712 = (_e18711 * _e18711);
let _e18716 = ((1f + _e18712) - ((2f * _e18711) * _e18708));
let _e18718 = select(1e-9f, _e18716, (_e18716 > 1e-9f));
let _e18730 = global_1.member.member_13.member_3;
if (_e18730 == 2u) {
let _e18735 = (0.5f - (0.5f * _e18708));
let _e18737 = select(0f, _e18735, (_e18735 > 0f));
let _e18741 = (sqrt(select(0f, _e18737, (_e18737 > 0f))) * 255f);
let _e18742 = (255f - 1f);
let _e18744 = select(0f, _e18741, (_e18741 > 0f));
let _e18746 = select(_e18742, _e18744, (_e18744 < _e18742));
let _e18753 = select(0i, select(select(i32(_e18746), i32(-2147483648), (_e18746 < -2147483600f)), 2147483647i, (_e18746 > 2147483500f)), (_e18746 == _e18746));
let _e18757 = (_e18753 - select(0i, 1i, (_e18746 < f32(_e18753))));
let _e18760 = global_1.member.member_13.member_11;
let _e18761 = bitcast<i32>(_e18760);
let _e18762 = (_e18761 + _e18757);
let _e18764 = (bitcast<i32>(_e299) - 1i);
let _e18766 = select(_e18764, _e18762, (_e18762 < _e18764));
let _e18771 = global_2.member[bitcast<u32>(select(0i, _e18766, (_e18766 > 0i)))];
let _e18773 = (_e18761 + (_e18757 + 1i));
let _e18775 = select(_e18764, _e18773, (_e18773 < _e18764));
let _e18780 = global_2.member[bitcast<u32>(select(0i, _e18775, (_e18775 > 0i)))];
phi_32446_ = (_e18771 + ((_e18780 - _e18771) * (_e18741 - f32(_e18757))));
} else {
phi_32446_ = select(((1f - _e18712) / (_e18718 * sqrt(select(0f, _e18718, (_e18718 > 0f))))), (0.75f * (1f + (_e18708 * _e18708))), (_e18730 == 1u));
}
let _e18787 = phi_32446_;
let _e18799 = global_1.member.member_13.member_7;
let _e18800 = bitcast<i32>(_e18799);
let _e18803 = global_1.member.member_13.member_8;
let _e18804 = bitcast<i32>(_e18803);
let _e18807 = global_1.member.member_13.member_9;
let _e18808 = bitcast<i32>(_e18807);
let _e18811 = global_1.member.member_13.member_4;
let _e18817 = global_1.member.member_13.member_5;
let _e18821 = f32(_e18800);
let _e18826 = (((((_e18647 + (_e18659 * _e18699)) - _e18811.member) / (_e18817.member - _e18811.member)) * _e18821) - 0.5f);
let _e18827 = (_e18821 - 1f);
let _e18829 = select(0f, _e18826, (_e18826 > 0f));
let _e18831 = select(_e18827, _e18829, (_e18829 < _e18827));
let _e18832 = f32(_e18804);
let _e18837 = (((((_e18648 + (_e18660 * _e18699)) - _e18811.member_1) / (_e18817.member_1 - _e18811.member_1)) * _e18832) - 0.5f);
let _e18838 = (_e18832 - 1f);
let _e18840 = select(0f, _e18837, (_e18837 > 0f));
let _e18842 = select(_e18838, _e18840, (_e18840 < _e18838));
let _e18843 = f32(_e18808);
let _e18848 = (((((_e18649 + (_e18661 * _e18699)) - _e18811.member_2) / (_e18817.member_2 - _e18811.member_2)) * _e18843) - 0.5f);
let _e18849 = (_e18843 - 1f);
let _e18851 = select(0f, _e18848, (_e18848 > 0f));
let _e18853 = select(_e18849, _e18851, (_e18851 < _e18849));
let _e18855 = select(0f, _e18831, (_e18831 > 0f));
let _e18857 = select(1e6f, _e18855, (_e18855 < 1e6f));
let _e18864 = select(0i, select(select(i32(_e18857), i32(-2147483648), (_e18857 < -2147483600f)), 2147483647i, (_e18857 > 2147483500f)), (_e18857 == _e18857));
let _e18868 = (_e18864 - select(0i, 1i, (_e18857 < f32(_e18864))));
let _e18870 = select(0f, _e18842, (_e18842 > 0f));
let _e18872 = select(1e6f, _e18870, (_e18870 < 1e6f));
let _e18879 = select(0i, select(select(i32(_e18872), i32(-2147483648), (_e18872 < -2147483600f)), 2147483647i, (_e18872 > 2147483500f)), (_e18872 == _e18872));
let _e18883 = (_e18879 - select(0i, 1i, (_e18872 < f32(_e18879))));
let _e18885 = select(0f, _e18853, (_e18853 > 0f));
let _e18887 = select(1e6f, _e18885, (_e18885 < 1e6f));
let _e18894 = select(0i, select(select(i32(_e18887), i32(-2147483648), (_e18887 < -2147483600f)), 2147483647i, (_e18887 > 2147483500f)), (_e18887 == _e18887));
let _e18898 = (_e18894 - select(0i, 1i, (_e18887 < f32(_e18894))));
let _e18902 = (_e18842 - f32(_e18883));
let _e18904 = (_e18853 - f32(_e18898));
local_138 = (_e18831 - f32(_e18868));
let _e18905 = (_e18868 + 1i);
let _e18907 = select(_e18905, 0i, (_e18905 < 0i));
if (_e18907 >= _e18800) {
phi_32578_ = (_e18800 - 1i);
} else {
phi_32578_ = _e18907;
}
let _e18911 = phi_32578_;
local_139 = (_e18911 - _e18868);
let _e18913 = (_e18883 + 1i);
let _e18915 = select(_e18913, 0i, (_e18913 < 0i));
if (_e18915 >= _e18804) {
phi_32591_ = (_e18804 - 1i);
} else {
phi_32591_ = _e18915;
}
let _e18919 = phi_32591_;
let _e18921 = ((_e18919 - _e18883) * _e18800);
let _e18922 = (_e18898 + 1i);
let _e18924 = select(_e18922, 0i, (_e18922 < 0i));
if (_e18924 >= _e18808) {
phi_32605_ = (_e18808 - 1i);
} else {
phi_32605_ = _e18924;
}
let _e18928 = phi_32605_;
let _e18934 = global_1.member.member_13.member_10;
let _e18940 = ((bitcast<i32>(_e18934) + (((_e18898 * _e18804) + _e18883) * _e18800)) + _e18868);
let _e18942 = (bitcast<i32>(_e299) - 1i);
let _e18944 = select(_e18942, _e18940, (_e18940 < _e18942));
let _e18949 = global_2.member[bitcast<u32>(select(0i, _e18944, (_e18944 > 0i)))];
let _e18950 = local_138;
let _e18953 = local_139;
let _e18954 = (_e18940 + _e18953);
let _e18956 = select(_e18942, _e18954, (_e18954 < _e18942));
let _e18961 = global_2.member[bitcast<u32>(select(0i, _e18956, (_e18956 > 0i)))];
let _e18962 = local_138;
let _e18965 = (1f - _e18902);
let _e18967 = (_e18940 + _e18921);
let _e18969 = select(_e18942, _e18967, (_e18967 < _e18942));
let _e18974 = global_2.member[bitcast<u32>(select(0i, _e18969, (_e18969 > 0i)))];
let _e18975 = local_138;
let _e18978 = local_139;
let _e18979 = (_e18967 + _e18978);
let _e18981 = select(_e18942, _e18979, (_e18979 < _e18942));
let _e18986 = global_2.member[bitcast<u32>(select(0i, _e18981, (_e18981 > 0i)))];
let _e18987 = local_138;
let _e18992 = (_e18940 + (((_e18928 - _e18898) * _e18800) * _e18804));
let _e18994 = select(_e18942, _e18992, (_e18992 < _e18942));
let _e18999 = global_2.member[bitcast<u32>(select(0i, _e18994, (_e18994 > 0i)))];
let _e19000 = local_138;
let _e19003 = local_139;
let _e19004 = (_e18992 + _e19003);
let _e19006 = select(_e18942, _e19004, (_e19004 < _e18942));
let _e19011 = global_2.member[bitcast<u32>(select(0i, _e19006, (_e19006 > 0i)))];
let _e19012 = local_138;
let _e19016 = (_e18992 + _e18921);
let _e19018 = select(_e18942, _e19016, (_e19016 < _e18942));
let _e19023 = global_2.member[bitcast<u32>(select(0i, _e19018, (_e19018 > 0i)))];
let _e19024 = local_138;
let _e19027 = local_139;
let _e19028 = (_e19016 + _e19027);
let _e19030 = select(_e18942, _e19028, (_e19028 < _e18942));
let _e19035 = global_2.member[bitcast<u32>(select(0i, _e19030, (_e19030 > 0i)))];
let _e19036 = local_138;
let _e19045 = ((_e18657 * (_e18787 * (0.25f / 3.1415927f))) * ((((((_e18949 * (1f - _e18950)) + (_e18961 * _e18962)) * _e18965) + (((_e18974 * (1f - _e18975)) + (_e18986 * _e18987)) * _e18902)) * (1f - _e18904)) + (((((_e18999 * (1f - _e19000)) + (_e19011 * _e19012)) * _e18965) + (((_e19023 * (1f - _e19024)) + (_e19035 * _e19036)) * _e18902)) * _e18904)));
let _e19048 = global_1.member.member_12.member_12;
let _e19051 = global_1.member.member_12.member_4;
let _e19054 = global_1.member.member_12.member_13;
let _e19060 = global_1.member.member.member;
let _e19062 = (_e18702 / _e725);
local_135 = bitcast<i32>((_e19048 + (_e19051 * _e19054)));
local_136 = _e315;
local_137 = bitcast<i32>(_e19060);
let _e19065 = global_1.member.member_13.member_6;
let _e19066 = f32(_e19065);
let _e19068 = select(0f, _e19062, (_e19062 > 0f));
let _e19071 = (select(1f, _e19068, (_e19068 < 1f)) * _e19066);
let _e19072 = (_e19066 - 1f);
let _e19074 = select(0f, _e19072, (_e19072 > 0f));
let _e19076 = select(0f, _e19071, (_e19071 > 0f));
let _e19078 = select(_e19074, _e19076, (_e19076 < _e19074));
let _e19085 = select(0i, select(select(i32(_e19078), i32(-2147483648), (_e19078 < -2147483600f)), 2147483647i, (_e19078 > 2147483500f)), (_e19078 == _e19078));
let _e19089 = (_e19085 - select(0i, 1i, (_e19078 < f32(_e19085))));
if (_e19089 > 0i) {
let _e19092 = local_135;
let _e19093 = local_137;
let _e19096 = local_136;
let _e19097 = ((_e19092 + ((_e19089 - 1i) * _e19093)) + _e19096);
let _e19099 = (bitcast<i32>(_e302) - 1i);
let _e19101 = select(_e19099, _e19097, (_e19097 < _e19099));
let _e19106 = global_7.member[bitcast<u32>(select(0i, _e19101, (_e19101 > 0i)))];
phi_32909_ = _e19106;
} else {
phi_32909_ = 0f;
}
let _e19108 = phi_32909_;
let _e19109 = local_135;
let _e19110 = local_137;
let _e19113 = local_136;
let _e19114 = ((_e19109 + (_e19089 * _e19110)) + _e19113);
let _e19116 = (bitcast<i32>(_e302) - 1i);
let _e19118 = select(_e19116, _e19114, (_e19114 < _e19116));
let _e19123 = global_7.member[bitcast<u32>(select(0i, _e19118, (_e19118 > 0i)))];
let _e19130 = (_e18575 - _e18564);
let _e19133 = ((_e18699 - _e18564) / select(1e-9f, _e19130, (_e19130 > 1e-9f)));
local_132 = 0i;
local_133 = _e18584;
local_134 = _e18550;
let _e19135 = select(0f, _e19133, (_e19133 > 0f));
let _e19138 = (select(1f, _e19135, (_e19135 < 1f)) * _e19066);
let _e19140 = select(0f, _e19138, (_e19138 > 0f));
let _e19142 = select(_e19074, _e19140, (_e19140 < _e19074));
let _e19149 = select(0i, select(select(i32(_e19142), i32(-2147483648), (_e19142 < -2147483600f)), 2147483647i, (_e19142 > 2147483500f)), (_e19142 == _e19142));
let _e19153 = (_e19149 - select(0i, 1i, (_e19142 < f32(_e19149))));
if (_e19153 > 0i) {
let _e19156 = local_132;
let _e19157 = local_134;
let _e19160 = local_133;
let _e19161 = ((_e19156 + ((_e19153 - 1i) * _e19157)) + _e19160);
let _e19163 = select(_e19116, _e19161, (_e19161 < _e19116));
let _e19168 = global_7.member[bitcast<u32>(select(0i, _e19163, (_e19163 > 0i)))];
phi_33036_ = _e19168;
} else {
phi_33036_ = 0f;
}
let _e19170 = phi_33036_;
let _e19171 = local_132;
let _e19172 = local_134;
let _e19175 = local_133;
let _e19176 = ((_e19171 + (_e19153 * _e19172)) + _e19175);
let _e19178 = select(_e19116, _e19176, (_e19176 < _e19116));
let _e19183 = global_7.member[bitcast<u32>(select(0i, _e19178, (_e19178 > 0i)))];
let _e19189 = ((_e19108 + ((_e19123 - _e19108) * (_e19071 - f32(_e19089)))) + (_e19170 + ((_e19183 - _e19170) * (_e19138 - f32(_e19153)))));
let _e19192 = global_1.member.member_13.member;
let _e19197 = -((_e19192.member * _e19189));
let _e19199 = select(-87f, _e19197, (_e19197 > -87f));
let _e19201 = select(88f, _e19199, (_e19199 < 88f));
let _e19203 = ((_e19201 * 1.442695f) + 0.5f);
let _e19205 = select(-127f, _e19203, (_e19203 > -127f));
let _e19207 = select(128f, _e19205, (_e19205 < 128f));
let _e19214 = select(0i, select(select(i32(_e19207), i32(-2147483648), (_e19207 < -2147483600f)), 2147483647i, (_e19207 > 2147483500f)), (_e19207 == _e19207));
let _e19218 = (_e19214 - select(0i, 1i, (_e19207 < f32(_e19214))));
let _e19219 = f32(_e19218);
let _e19223 = ((_e19201 - (_e19219 * 0.6933594f)) - (_e19219 * -2.1219444e-4f));
let _e19245 = -((_e19192.member_1 * _e19189));
let _e19247 = select(-87f, _e19245, (_e19245 > -87f));
let _e19249 = select(88f, _e19247, (_e19247 < 88f));
let _e19251 = ((_e19249 * 1.442695f) + 0.5f);
let _e19253 = select(-127f, _e19251, (_e19251 > -127f));
let _e19255 = select(128f, _e19253, (_e19253 < 128f));
let _e19262 = select(0i, select(select(i32(_e19255), i32(-2147483648), (_e19255 < -2147483600f)), 2147483647i, (_e19255 > 2147483500f)), (_e19255 == _e19255));
let _e19266 = (_e19262 - select(0i, 1i, (_e19255 < f32(_e19262))));
let _e19267 = f32(_e19266);
let _e19271 = ((_e19249 - (_e19267 * 0.6933594f)) - (_e19267 * -2.1219444e-4f));
let _e19293 = -((_e19192.member_2 * _e19189));
let _e19295 = select(-87f, _e19293, (_e19293 > -87f));
let _e19297 = select(88f, _e19295, (_e19295 < 88f));
let _e19299 = ((_e19297 * 1.442695f) + 0.5f);
let _e19301 = select(-127f, _e19299, (_e19299 > -127f));
let _e19303 = select(128f, _e19301, (_e19301 < 128f));
let _e19310 = select(0i, select(select(i32(_e19303), i32(-2147483648), (_e19303 < -2147483600f)), 2147483647i, (_e19303 > 2147483500f)), (_e19303 == _e19303));
let _e19314 = (_e19310 - select(0i, 1i, (_e19303 < f32(_e19310))));
let _e19315 = f32(_e19314);
let _e19319 = ((_e19297 - (_e19315 * 0.6933594f)) - (_e19315 * -2.1219444e-4f));
let _e19342 = global_1.member.member_13.member_1;
let _e19355 = select(0f, _e18699, (((_e18702 >= 0f) && (_e18702 < _e725)) && (_e18699 > 0f)));
if _e487 {
phi_33300_ = type_26(_e18492, _e18399);
} else {
phi_33300_ = type_26(_e18399, _e18492);
}
let _e19366 = phi_33300_;
let _e19369 = (_e18493 && (((_e19355 > 0f) && (_e19355 < _e18583)) && true));
let _e19372 = global_1.member.member_18.member;
let _e19373 = (((select(_e18518, (1f - _e18518), (_e18503 >= 0f)) - select(_e18537, (1f - _e18537), (_e18522 >= 0f))) * (1f / _e18500)) * _e19372);
let _e19377 = select(0f, (((((_e686 * _e19342.member) * ((1f + (_e19223 * (1f + (_e19223 * (0.5f + (_e19223 * (0.16666667f + (_e19223 * (0.041666668f + (_e19223 * (0.008333334f + (_e19223 * (0.001388889f + (_e19223 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e19218 + 127i)) << bitcast<u32>(23i))))) * _e19045) * 1f) * _e19373), _e19369);
let _e19378 = select(0f, (((((_e699 * _e19342.member_1) * ((1f + (_e19271 * (1f + (_e19271 * (0.5f + (_e19271 * (0.16666667f + (_e19271 * (0.041666668f + (_e19271 * (0.008333334f + (_e19271 * (0.001388889f + (_e19271 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e19266 + 127i)) << bitcast<u32>(23i))))) * _e19045) * 1f) * _e19373), _e19369);
let _e19379 = select(0f, (((((_e712 * _e19342.member_2) * ((1f + (_e19319 * (1f + (_e19319 * (0.5f + (_e19319 * (0.16666667f + (_e19319 * (0.041666668f + (_e19319 * (0.008333334f + (_e19319 * (0.001388889f + (_e19319 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e19314 + 127i)) << bitcast<u32>(23i))))) * _e19045) * 1f) * _e19373), _e19369);
let _e19383 = (bitcast<f32>((bitcast<u32>(_e19377) & 2147483647u)) >= 1073741800f);
let _e19384 = (1f / 1048576f);
let _e19387 = ((_e19377 * select(1f, _e19384, _e19383)) + 0.5f);
let _e19389 = select(-1073741800f, _e19387, (_e19387 > -1073741800f));
let _e19391 = select(1073741800f, _e19389, (_e19389 < 1073741800f));
let _e19398 = select(0i, select(select(i32(_e19391), i32(-2147483648), (_e19391 < -2147483600f)), 2147483647i, (_e19391 > 2147483500f)), (_e19391 == _e19391));
let _e19402 = (_e19398 - select(0i, 1i, (_e19391 < f32(_e19398))));
let _e19403 = select(0i, 20i, _e19383);
let _e19407 = (bitcast<u32>(_e19402) << bitcast<u32>((_e19403 & 31i)));
let _e19414 = bitcast<u32>(((_e19402 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e19403) & 31i))));
let _e19418 = (bitcast<f32>((bitcast<u32>(_e19378) & 2147483647u)) >= 1073741800f);
let _e19421 = ((_e19378 * select(1f, _e19384, _e19418)) + 0.5f);
let _e19423 = select(-1073741800f, _e19421, (_e19421 > -1073741800f));
let _e19425 = select(1073741800f, _e19423, (_e19423 < 1073741800f));
let _e19432 = select(0i, select(select(i32(_e19425), i32(-2147483648), (_e19425 < -2147483600f)), 2147483647i, (_e19425 > 2147483500f)), (_e19425 == _e19425));
let _e19436 = (_e19432 - select(0i, 1i, (_e19425 < f32(_e19432))));
let _e19437 = select(0i, 20i, _e19418);
let _e19441 = (bitcast<u32>(_e19436) << bitcast<u32>((_e19437 & 31i)));
let _e19448 = bitcast<u32>(((_e19436 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e19437) & 31i))));
let _e19452 = (bitcast<f32>((bitcast<u32>(_e19379) & 2147483647u)) >= 1073741800f);
let _e19455 = ((_e19379 * select(1f, _e19384, _e19452)) + 0.5f);
let _e19457 = select(-1073741800f, _e19455, (_e19455 > -1073741800f));
let _e19459 = select(1073741800f, _e19457, (_e19457 < 1073741800f));
let _e19466 = select(0i, select(select(i32(_e19459), i32(-2147483648), (_e19459 < -2147483600f)), 2147483647i, (_e19459 > 2147483500f)), (_e19459 == _e19459));
let _e19470 = (_e19466 - select(0i, 1i, (_e19459 < f32(_e19466))));
let _e19471 = select(0i, 20i, _e19452);
let _e19475 = (bitcast<u32>(_e19470) << bitcast<u32>((_e19471 & 31i)));
let _e19482 = bitcast<u32>(((_e19470 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e19471) & 31i))));
let _e19487 = bitcast<i32>(bitcast<u32>((((_e19366.member_1 * _e11947) + _e19366.member) * 6i)));
if ((_e19407 | _e19414) == 0u) {
} else {
let _e19490 = bitcast<u32>(_e19487);
if (_e19490 < _e304) {
let _e19494 = atomicAdd((&global_8.member[_e19490]), _e19407);
phi_33533_ = _e19494;
} else {
phi_33533_ = 0u;
}
let _e19496 = phi_33533_;
let _e19500 = (_e19414 + select(0u, 1u, ((_e19496 + _e19407) < _e19407)));
if (_e19500 == 0u) {
} else {
let _e19502 = (_e19490 + 1u);
if (_e19502 < _e304) {
let _e19506 = atomicAdd((&global_8.member[_e19502]), _e19500);
}
}
}
if ((_e19441 | _e19448) == 0u) {
} else {
let _e19510 = bitcast<u32>((_e19487 + 2i));
if (_e19510 < _e304) {
let _e19514 = atomicAdd((&global_8.member[_e19510]), _e19441);
phi_33563_ = _e19514;
} else {
phi_33563_ = 0u;
}
let _e19516 = phi_33563_;
let _e19520 = (_e19448 + select(0u, 1u, ((_e19516 + _e19441) < _e19441)));
if (_e19520 == 0u) {
} else {
let _e19522 = (_e19510 + 1u);
if (_e19522 < _e304) {
let _e19526 = atomicAdd((&global_8.member[_e19522]), _e19520);
}
}
}
if ((_e19475 | _e19482) == 0u) {
} else {
let _e19530 = bitcast<u32>((_e19487 + 4i));
if (_e19530 < _e304) {
let _e19534 = atomicAdd((&global_8.member[_e19530]), _e19475);
phi_33593_ = _e19534;
} else {
phi_33593_ = 0u;
}
let _e19536 = phi_33593_;
let _e19540 = (_e19482 + select(0u, 1u, ((_e19536 + _e19475) < _e19475)));
if (_e19540 == 0u) {
} else {
let _e19542 = (_e19530 + 1u);
if (_e19542 < _e304) {
let _e19546 = atomicAdd((&global_8.member[_e19542]), _e19540);
}
}
}
phi_31915_ = (_e18490 + 1i);
} else {
phi_31915_ = i32();
}
let _e19549 = phi_31915_;
continue;
continuing {
phi_31914_ = _e19549;
break if !(_e18493);
}
}
phi_31761_ = (_e18396 + 1i);
} else {
phi_31761_ = i32();
}
let _e19553 = phi_31761_;
continue;
continuing {
phi_31760_ = _e19553;
break if !(_e18397);
}
}
} else {
if (_e13362 == 1u) {
phi_33642_ = 0i;
loop {
let _e16544 = phi_33642_;
let _e16545 = (_e16544 < 16i);
if _e16545 {
let _e16547 = (_e11992 + (_e16544 & 15i));
let _e16549 = (f32(_e16547) + 0.5f);
let _e16551 = ((_e16549 * 1f) - 0.5f);
let _e16555 = (-(((_e450 * _e16551) + _e476)) / _e463);
let _e16562 = bitcast<f32>((bitcast<u32>(((_e500 * _e16551) + ((_e513 * _e16555) + _e526))) & 2147483647u));
let _e16569 = bitcast<f32>((bitcast<u32>(((_e539 * _e16551) + ((_e552 * _e16555) + _e565))) & 2147483647u));
let _e16573 = (((0.5f * (_e16562 + _e16569)) / _e568) + _e751);
let _e16574 = (1f / 1f);
let _e16582 = ((((_e16555 + _e16573) + 0.5f) * _e16574) - 0.5f);
let _e16583 = f32(_e13348);
let _e16584 = f32(_e13346);
let _e16585 = (_e16583 - 1f);
let _e16587 = select(_e16585, _e16582, (_e16582 > _e16585));
let _e16589 = select(_e16584, _e16587, (_e16587 < _e16584));
let _e16596 = select(0i, select(select(i32(_e16589), i32(-2147483648), (_e16589 < -2147483600f)), 2147483647i, (_e16589 > 2147483500f)), (_e16589 == _e16589));
let _e16601 = (((((_e16555 - _e16573) + 0.5f) * _e16574) - 0.5f) + 1f);
let _e16602 = (_e16584 + 1f);
let _e16604 = select(_e16583, _e16601, (_e16601 > _e16583));
let _e16606 = select(_e16602, _e16604, (_e16604 < _e16602));
let _e16613 = select(0i, select(select(i32(_e16606), i32(-2147483648), (_e16606 < -2147483600f)), 2147483647i, (_e16606 > 2147483500f)), (_e16606 == _e16606));
let _e16624 = ((1e-4f * 1f) * _e568);
let _e16626 = select(_e16569, _e16562, (_e16562 > _e16569));
let _e16628 = select(_e16624, _e16626, (_e16626 > _e16624));
let _e16630 = select(_e16569, _e16562, (_e16562 < _e16569));
let _e16632 = select(_e16624, _e16630, (_e16630 > _e16624));
let _e16634 = (0.5f * (_e16628 + _e16632));
let _e16635 = (0.5f / _e16632);
let _e16636 = (1f / _e16628);
phi_33796_ = 0i;
loop {
let _e16638 = phi_33796_;
let _e16640 = (((_e16613 - select(0i, 1i, (_e16606 < f32(_e16613)))) + (_e16544 >> bitcast<u32>(4u))) + bitcast<i32>(_e16638));
let _e16641 = (_e16640 <= select(-1i, (_e16596 - select(0i, 1i, (_e16589 < f32(_e16596)))), (_e16547 <= _e11996)));
if _e16641 {
let _e16643 = (f32(_e16640) + 0.5f);
let _e16647 = ((((_e16643 * 1f) - 0.5f) - _e16555) * _e568);
let _e16648 = (_e568 * 1f);
let _e16650 = (0.5f * _e16648);
let _e16651 = (_e16647 + _e16650);
let _e16652 = -(_e16651);
let _e16655 = (_e16634 - select(_e16652, _e16651, (_e16651 > _e16652)));
let _e16657 = select(0f, _e16655, (_e16655 > 0f));
let _e16659 = select(_e16632, _e16657, (_e16657 < _e16632));
let _e16662 = (_e16655 - _e16632);
let _e16666 = (((_e16659 * (_e16659 * _e16635)) + select(0f, _e16662, (_e16662 > 0f))) * _e16636);
let _e16670 = (_e16647 - _e16650);
let _e16671 = -(_e16670);
let _e16674 = (_e16634 - select(_e16671, _e16670, (_e16670 > _e16671)));
let _e16676 = select(0f, _e16674, (_e16674 > 0f));
let _e16678 = select(_e16632, _e16676, (_e16676 < _e16632));
let _e16681 = (_e16674 - _e16632);
let _e16685 = (((_e16678 * (_e16678 * _e16635)) + select(0f, _e16681, (_e16681 > 0f))) * _e16636);
if _e487 {
phi_33901_ = type_26(_e16640, _e16547);
} else {
phi_33901_ = type_26(_e16547, _e16640);
}
let _e16694 = phi_33901_;
let _e16698 = bitcast<i32>((_e11943 * _e11946));
local_130 = _e16698;
local_131 = ((_e16694.member_1 * _e11947) + _e16694.member);
let _e16701 = local_130;
let _e16702 = local_131;
let _e16703 = (_e16701 + _e16702);
let _e16705 = (bitcast<i32>(_e293) - 1i);
let _e16707 = select(_e16705, _e16703, (_e16703 < _e16705));
let _e16712 = global_5.member[bitcast<u32>(select(0i, _e16707, (_e16707 > 0i)))];
let _e16713 = local_130;
let _e16715 = local_131;
let _e16716 = ((2i * _e16713) + _e16715);
let _e16718 = select(_e16705, _e16716, (_e16716 < _e16705));
let _e16723 = global_5.member[bitcast<u32>(select(0i, _e16718, (_e16718 > 0i)))];
let _e16724 = local_131;
let _e16726 = select(_e16705, _e16724, (_e16724 < _e16705));
let _e16731 = global_5.member[bitcast<u32>(select(0i, _e16726, (_e16726 > 0i)))];
let _e16732 = local_131;
let _e16735 = f32(_e11947);
let _e16736 = f32(_e11948);
let _e16743 = global_1.member.member_2.member;
let _e16744 = (((((f32(_e16694.member) + 0.5f) / _e16735) * 2f) - 1f) * _e16743);
let _e16751 = global_1.member.member_2.member_1;
let _e16752 = ((1f - (((f32(_e16694.member_1) + 0.5f) / _e16736) * 2f)) * _e16751);
let _e16754 = global_1.member.member_3;
let _e16762 = global_1.member.member_4;
let _e16769 = ((_e16754.member * _e16744) + (_e16762.member * _e16752));
let _e16770 = ((_e16754.member_1 * _e16744) + (_e16762.member_1 * _e16752));
let _e16771 = ((_e16754.member_2 * _e16744) + (_e16762.member_2 * _e16752));
let _e16774 = global_1.member.member_2.member_3;
let _e16775 = (_e16774 != 0u);
let _e16777 = global_1.member.member_5;
let _e16784 = select((_e16777.member + _e16769), _e16777.member, _e16775);
let _e16785 = select((_e16777.member_1 + _e16770), _e16777.member_1, _e16775);
let _e16786 = select((_e16777.member_2 + _e16771), _e16777.member_2, _e16775);
let _e16788 = global_1.member.member_6;
let _e16795 = select(_e16788.member, (_e16788.member + _e16769), _e16775);
let _e16796 = select(_e16788.member_1, (_e16788.member_1 + _e16770), _e16775);
let _e16797 = select(_e16788.member_2, (_e16788.member_2 + _e16771), _e16775);
let _e16802 = (((_e16784 * _e16784) + (_e16785 * _e16785)) + (_e16786 * _e16786));
let _e16805 = sqrt(select(0f, _e16802, (_e16802 > 0f)));
let _e16806 = (1f / _e16805);
let _e16807 = (_e16784 * _e16806);
let _e16808 = (_e16785 * _e16806);
let _e16809 = (_e16786 * _e16806);
let _e16810 = (_e609 - _e16795);
let _e16811 = (_e621 - _e16796);
let _e16812 = (_e634 - _e16797);
let _e16817 = (((_e16810 * _e16807) + (_e16811 * _e16808)) + (_e16812 * _e16809));
let _e16822 = (((_e16810 * _e647) + (_e16811 * _e660)) + (_e16812 * _e673));
let _e16827 = (((_e16807 * _e647) + (_e16808 * _e660)) + (_e16809 * _e673));
let _e16830 = ((_e16808 * _e673) - (_e16809 * _e660));
let _e16833 = ((_e16809 * _e647) - (_e16807 * _e673));
let _e16836 = ((_e16807 * _e660) - (_e16808 * _e647));
let _e16841 = (((_e16830 * _e16830) + (_e16833 * _e16833)) + (_e16836 * _e16836));
let _e16844 = (1f / select(1e-9f, _e16841, (_e16841 > 1e-9f)));
let _e16847 = ((_e16817 - (_e16827 * _e16822)) * _e16844);
let _e16850 = (((_e16827 * _e16817) - _e16822) * _e16844);
let _e16856 = -(_e16827);
let _e16859 = global_1.member.member_13.member_2;
let _e16860 = (_e16859 * _e16859);
let _e16864 = ((1f + _e16860) - ((2f * _e16859) * _e16856));
let _e16866 = select(1e-9f, _e16864, (_e16864 > 1e-9f));
let _e16878 = global_1.member.member_13.member_3;
if (_e16878 == 2u) {
let _e16883 = (0.5f - (0.5f * _e16856));
let _e16885 = select(0f, _e16883, (_e16883 > 0f));
let _e16889 = (sqrt(select(0f, _e16885, (_e16885 > 0f))) * 255f);
let _e16890 = (255f - 1f);
let _e16892 = select(0f, _e16889, (_e16889 > 0f));
let _e16894 = select(_e16890, _e16892, (_e16892 < _e16890));
let _e16901 = select(0i, select(select(i32(_e16894), i32(-2147483648), (_e16894 < -2147483600f)), 2147483647i, (_e16894 > 2147483500f)), (_e16894 == _e16894));
let _e16905 = (_e16901 - select(0i, 1i, (_e16894 < f32(_e16901))));
let _e16908 = global_1.member.member_13.member_11;
let _e16909 = bitcast<i32>(_e16908);
let _e16910 = (_e16909 + _e16905);
let _e16912 = (bitcast<i32>(_e299) - 1i);
let _e16914 = select(_e16912, _e16910, (_e16910 < _e16912));
let _e16919 = global_2.member[bitcast<u32>(select(0i, _e16914, (_e16914 > 0i)))];
let _e16921 = (_e16909 + (_e16905 + 1i));
let _e16923 = select(_e16912, _e16921, (_e16921 < _e16912));
let _e16928 = global_2.member[bitcast<u32>(select(0i, _e16923, (_e16923 > 0i)))];
phi_34328_ = (_e16919 + ((_e16928 - _e16919) * (_e16889 - f32(_e16905))));
} else {
phi_34328_ = select(((1f - _e16860) / (_e16866 * sqrt(select(0f, _e16866, (_e16866 > 0f))))), (0.75f * (1f + (_e16856 * _e16856))), (_e16878 == 1u));
}
let _e16935 = phi_34328_;
let _e16947 = global_1.member.member_13.member_7;
let _e16948 = bitcast<i32>(_e16947);
let _e16951 = global_1.member.member_13.member_8;
let _e16952 = bitcast<i32>(_e16951);
let _e16955 = global_1.member.member_13.member_9;
let _e16956 = bitcast<i32>(_e16955);
let _e16959 = global_1.member.member_13.member_4;
let _e16965 = global_1.member.member_13.member_5;
let _e16969 = f32(_e16948);
let _e16974 = (((((_e16795 + (_e16807 * _e16847)) - _e16959.member) / (_e16965.member - _e16959.member)) * _e16969) - 0.5f);
let _e16975 = (_e16969 - 1f);
let _e16977 = select(0f, _e16974, (_e16974 > 0f));
let _e16979 = select(_e16975, _e16977, (_e16977 < _e16975));
let _e16980 = f32(_e16952);
let _e16985 = (((((_e16796 + (_e16808 * _e16847)) - _e16959.member_1) / (_e16965.member_1 - _e16959.member_1)) * _e16980) - 0.5f);
let _e16986 = (_e16980 - 1f);
let _e16988 = select(0f, _e16985, (_e16985 > 0f));
let _e16990 = select(_e16986, _e16988, (_e16988 < _e16986));
let _e16991 = f32(_e16956);
let _e16996 = (((((_e16797 + (_e16809 * _e16847)) - _e16959.member_2) / (_e16965.member_2 - _e16959.member_2)) * _e16991) - 0.5f);
let _e16997 = (_e16991 - 1f);
let _e16999 = select(0f, _e16996, (_e16996 > 0f));
let _e17001 = select(_e16997, _e16999, (_e16999 < _e16997));
let _e17003 = select(0f, _e16979, (_e16979 > 0f));
let _e17005 = select(1e6f, _e17003, (_e17003 < 1e6f));
let _e17012 = select(0i, select(select(i32(_e17005), i32(-2147483648), (_e17005 < -2147483600f)), 2147483647i, (_e17005 > 2147483500f)), (_e17005 == _e17005));
let _e17016 = (_e17012 - select(0i, 1i, (_e17005 < f32(_e17012))));
let _e17018 = select(0f, _e16990, (_e16990 > 0f));
let _e17020 = select(1e6f, _e17018, (_e17018 < 1e6f));
let _e17027 = select(0i, select(select(i32(_e17020), i32(-2147483648), (_e17020 < -2147483600f)), 2147483647i, (_e17020 > 2147483500f)), (_e17020 == _e17020));
let _e17031 = (_e17027 - select(0i, 1i, (_e17020 < f32(_e17027))));
let _e17033 = select(0f, _e17001, (_e17001 > 0f));
let _e17035 = select(1e6f, _e17033, (_e17033 < 1e6f));
let _e17042 = select(0i, select(select(i32(_e17035), i32(-2147483648), (_e17035 < -2147483600f)), 2147483647i, (_e17035 > 2147483500f)), (_e17035 == _e17035));
let _e17046 = (_e17042 - select(0i, 1i, (_e17035 < f32(_e17042))));
let _e17050 = (_e16990 - f32(_e17031));
let _e17052 = (_e17001 - f32(_e17046));
local_128 = (_e16979 - f32(_e17016));
let _e17053 = (_e17016 + 1i);
let _e17055 = select(_e17053, 0i, (_e17053 < 0i));
if (_e17055 >= _e16948) {
phi_34460_ = (_e16948 - 1i);
} else {
phi_34460_ = _e17055;
}
let _e17059 = phi_34460_;
local_129 = (_e17059 - _e17016);
let _e17061 = (_e17031 + 1i);
let _e17063 = select(_e17061, 0i, (_e17061 < 0i));
if (_e17063 >= _e16952) {
phi_34473_ = (_e16952 - 1i);
} else {
phi_34473_ = _e17063;
}
let _e17067 = phi_34473_;
let _e17069 = ((_e17067 - _e17031) * _e16948);
let _e17070 = (_e17046 + 1i);
let _e17072 = select(_e17070, 0i, (_e17070 < 0i));
if (_e17072 >= _e16956) {
phi_34487_ = (_e16956 - 1i);
} else {
phi_34487_ = _e17072;
}
let _e17076 = phi_34487_;
let _e17082 = global_1.member.member_13.member_10;
let _e17088 = ((bitcast<i32>(_e17082) + (((_e17046 * _e16952) + _e17031) * _e16948)) + _e17016);
let _e17090 = (bitcast<i32>(_e299) - 1i);
let _e17092 = select(_e17090, _e17088, (_e17088 < _e17090));
let _e17097 = global_2.member[bitcast<u32>(select(0i, _e17092, (_e17092 > 0i)))];
let _e17098 = local_128;
let _e17101 = local_129;
let _e17102 = (_e17088 + _e17101);
let _e17104 = select(_e17090, _e17102, (_e17102 < _e17090));
let _e17109 = global_2.member[bitcast<u32>(select(0i, _e17104, (_e17104 > 0i)))];
let _e17110 = local_128;
let _e17113 = (1f - _e17050);
let _e17115 = (_e17088 + _e17069);
let _e17117 = select(_e17090, _e17115, (_e17115 < _e17090));
let _e17122 = global_2.member[bitcast<u32>(select(0i, _e17117, (_e17117 > 0i)))];
let _e17123 = local_128;
let _e17126 = local_129;
let _e17127 = (_e17115 + _e17126);
let _e17129 = select(_e17090, _e17127, (_e17127 < _e17090));
let _e17134 = global_2.member[bitcast<u32>(select(0i, _e17129, (_e17129 > 0i)))];
let _e17135 = local_128;
let _e17140 = (_e17088 + (((_e17076 - _e17046) * _e16948) * _e16952));
let _e17142 = select(_e17090, _e17140, (_e17140 < _e17090));
let _e17147 = global_2.member[bitcast<u32>(select(0i, _e17142, (_e17142 > 0i)))];
let _e17148 = local_128;
let _e17151 = local_129;
let _e17152 = (_e17140 + _e17151);
let _e17154 = select(_e17090, _e17152, (_e17152 < _e17090));
let _e17159 = global_2.member[bitcast<u32>(select(0i, _e17154, (_e17154 > 0i)))];
let _e17160 = local_128;
let _e17164 = (_e17140 + _e17069);
let _e17166 = select(_e17090, _e17164, (_e17164 < _e17090));
let _e17171 = global_2.member[bitcast<u32>(select(0i, _e17166, (_e17166 > 0i)))];
let _e17172 = local_128;
let _e17175 = local_129;
let _e17176 = (_e17164 + _e17175);
let _e17178 = select(_e17090, _e17176, (_e17176 < _e17090));
let _e17183 = global_2.member[bitcast<u32>(select(0i, _e17178, (_e17178 > 0i)))];
let _e17184 = local_128;
let _e17193 = ((_e16805 * (_e16935 * (0.25f / 3.1415927f))) * ((((((_e17097 * (1f - _e17098)) + (_e17109 * _e17110)) * _e17113) + (((_e17122 * (1f - _e17123)) + (_e17134 * _e17135)) * _e17050)) * (1f - _e17052)) + (((((_e17147 * (1f - _e17148)) + (_e17159 * _e17160)) * _e17113) + (((_e17171 * (1f - _e17172)) + (_e17183 * _e17184)) * _e17050)) * _e17052)));
let _e17196 = global_1.member.member_12.member_12;
let _e17199 = global_1.member.member_12.member_4;
let _e17202 = global_1.member.member_12.member_13;
let _e17208 = global_1.member.member.member;
let _e17210 = (_e16850 / _e725);
local_125 = bitcast<i32>((_e17196 + (_e17199 * _e17202)));
local_126 = _e315;
local_127 = bitcast<i32>(_e17208);
let _e17213 = global_1.member.member_13.member_6;
let _e17214 = f32(_e17213);
let _e17216 = select(0f, _e17210, (_e17210 > 0f));
let _e17219 = (select(1f, _e17216, (_e17216 < 1f)) * _e17214);
let _e17220 = (_e17214 - 1f);
let _e17222 = select(0f, _e17220, (_e17220 > 0f));
let _e17224 = select(0f, _e17219, (_e17219 > 0f));
let _e17226 = select(_e17222, _e17224, (_e17224 < _e17222));
let _e17233 = select(0i, select(select(i32(_e17226), i32(-2147483648), (_e17226 < -2147483600f)), 2147483647i, (_e17226 > 2147483500f)), (_e17226 == _e17226));
let _e17237 = (_e17233 - select(0i, 1i, (_e17226 < f32(_e17233))));
if (_e17237 > 0i) {
let _e17240 = local_125;
let _e17241 = local_127;
let _e17244 = local_126;
let _e17245 = ((_e17240 + ((_e17237 - 1i) * _e17241)) + _e17244);
let _e17247 = (bitcast<i32>(_e302) - 1i);
let _e17249 = select(_e17247, _e17245, (_e17245 < _e17247));
let _e17254 = global_7.member[bitcast<u32>(select(0i, _e17249, (_e17249 > 0i)))];
phi_34791_ = _e17254;
} else {
phi_34791_ = 0f;
}
let _e17256 = phi_34791_;
let _e17257 = local_125;
let _e17258 = local_127;
let _e17261 = local_126;
let _e17262 = ((_e17257 + (_e17237 * _e17258)) + _e17261);
let _e17264 = (bitcast<i32>(_e302) - 1i);
let _e17266 = select(_e17264, _e17262, (_e17262 < _e17264));
let _e17271 = global_7.member[bitcast<u32>(select(0i, _e17266, (_e17266 > 0i)))];
let _e17278 = (_e16723 - _e16712);
let _e17281 = ((_e16847 - _e16712) / select(1e-9f, _e17278, (_e17278 > 1e-9f)));
local_122 = 0i;
local_123 = _e16732;
local_124 = _e16698;
let _e17283 = select(0f, _e17281, (_e17281 > 0f));
let _e17286 = (select(1f, _e17283, (_e17283 < 1f)) * _e17214);
let _e17288 = select(0f, _e17286, (_e17286 > 0f));
let _e17290 = select(_e17222, _e17288, (_e17288 < _e17222));
let _e17297 = select(0i, select(select(i32(_e17290), i32(-2147483648), (_e17290 < -2147483600f)), 2147483647i, (_e17290 > 2147483500f)), (_e17290 == _e17290));
let _e17301 = (_e17297 - select(0i, 1i, (_e17290 < f32(_e17297))));
if (_e17301 > 0i) {
let _e17304 = local_122;
let _e17305 = local_124;
let _e17308 = local_123;
let _e17309 = ((_e17304 + ((_e17301 - 1i) * _e17305)) + _e17308);
let _e17311 = select(_e17264, _e17309, (_e17309 < _e17264));
let _e17316 = global_7.member[bitcast<u32>(select(0i, _e17311, (_e17311 > 0i)))];
phi_34918_ = _e17316;
} else {
phi_34918_ = 0f;
}
let _e17318 = phi_34918_;
let _e17319 = local_122;
let _e17320 = local_124;
let _e17323 = local_123;
let _e17324 = ((_e17319 + (_e17301 * _e17320)) + _e17323);
let _e17326 = select(_e17264, _e17324, (_e17324 < _e17264));
let _e17331 = global_7.member[bitcast<u32>(select(0i, _e17326, (_e17326 > 0i)))];
let _e17337 = ((_e17256 + ((_e17271 - _e17256) * (_e17219 - f32(_e17237)))) + (_e17318 + ((_e17331 - _e17318) * (_e17286 - f32(_e17301)))));
let _e17340 = global_1.member.member_13.member;
let _e17345 = -((_e17340.member * _e17337));
let _e17347 = select(-87f, _e17345, (_e17345 > -87f));
let _e17349 = select(88f, _e17347, (_e17347 < 88f));
let _e17351 = ((_e17349 * 1.442695f) + 0.5f);
let _e17353 = select(-127f, _e17351, (_e17351 > -127f));
let _e17355 = select(128f, _e17353, (_e17353 < 128f));
let _e17362 = select(0i, select(select(i32(_e17355), i32(-2147483648), (_e17355 < -2147483600f)), 2147483647i, (_e17355 > 2147483500f)), (_e17355 == _e17355));
let _e17366 = (_e17362 - select(0i, 1i, (_e17355 < f32(_e17362))));
let _e17367 = f32(_e17366);
let _e17371 = ((_e17349 - (_e17367 * 0.6933594f)) - (_e17367 * -2.1219444e-4f));
let _e17393 = -((_e17340.member_1 * _e17337));
let _e17395 = select(-87f, _e17393, (_e17393 > -87f));
let _e17397 = select(88f, _e17395, (_e17395 < 88f));
let _e17399 = ((_e17397 * 1.442695f) + 0.5f);
let _e17401 = select(-127f, _e17399, (_e17399 > -127f));
let _e17403 = select(128f, _e17401, (_e17401 < 128f));
let _e17410 = select(0i, select(select(i32(_e17403), i32(-2147483648), (_e17403 < -2147483600f)), 2147483647i, (_e17403 > 2147483500f)), (_e17403 == _e17403));
let _e17414 = (_e17410 - select(0i, 1i, (_e17403 < f32(_e17410))));
let _e17415 = f32(_e17414);
let _e17419 = ((_e17397 - (_e17415 * 0.6933594f)) - (_e17415 * -2.1219444e-4f));
let _e17441 = -((_e17340.member_2 * _e17337));
let _e17443 = select(-87f, _e17441, (_e17441 > -87f));
let _e17445 = select(88f, _e17443, (_e17443 < 88f));
let _e17447 = ((_e17445 * 1.442695f) + 0.5f);
let _e17449 = select(-127f, _e17447, (_e17447 > -127f));
let _e17451 = select(128f, _e17449, (_e17449 < 128f));
let _e17458 = select(0i, select(select(i32(_e17451), i32(-2147483648), (_e17451 < -2147483600f)), 2147483647i, (_e17451 > 2147483500f)), (_e17451 == _e17451));
let _e17462 = (_e17458 - select(0i, 1i, (_e17451 < f32(_e17458))));
let _e17463 = f32(_e17462);
let _e17467 = ((_e17445 - (_e17463 * 0.6933594f)) - (_e17463 * -2.1219444e-4f));
let _e17490 = global_1.member.member_13.member_1;
let _e17503 = select(0f, _e16847, (((_e16850 >= 0f) && (_e16850 < _e725)) && (_e16847 > 0f)));
let _e17505 = ((_e800 + _e13350) + _e13354);
let _e17506 = (_e17505 & 31u);
let _e17508 = (1u << bitcast<u32>(_e17506));
let _e17517 = bitcast<i32>((((_e11943 + _e17508) - 1u) >> bitcast<u32>(_e17506)));
let _e17518 = bitcast<i32>((((_e11946 + _e17508) - 1u) >> bitcast<u32>(_e17506)));
if _e487 {
phi_35208_ = type_26(_e17518, _e17517);
} else {
phi_35208_ = type_26(_e17517, _e17518);
}
let _e17522 = phi_35208_;
let _e17527 = f32((1i << bitcast<u32>(_e17506)));
let _e17528 = (1f / _e17527);
let _e17530 = ((_e16549 * _e17528) - 0.5f);
let _e17532 = ((_e16643 * _e17528) - 0.5f);
let _e17534 = select(-1f, _e17530, (_e17530 > -1f));
let _e17536 = select(1e6f, _e17534, (_e17534 < 1e6f));
let _e17543 = select(0i, select(select(i32(_e17536), i32(-2147483648), (_e17536 < -2147483600f)), 2147483647i, (_e17536 > 2147483500f)), (_e17536 == _e17536));
let _e17547 = (_e17543 - select(0i, 1i, (_e17536 < f32(_e17543))));
let _e17549 = select(-1f, _e17532, (_e17532 > -1f));
let _e17551 = select(1e6f, _e17549, (_e17549 < 1e6f));
let _e17558 = select(0i, select(select(i32(_e17551), i32(-2147483648), (_e17551 < -2147483600f)), 2147483647i, (_e17551 > 2147483500f)), (_e17551 == _e17551));
let _e17562 = (_e17558 - select(0i, 1i, (_e17551 < f32(_e17558))));
let _e17564 = (_e17530 - f32(_e17547));
let _e17566 = (_e17532 - f32(_e17562));
let _e17567 = (1f - _e17564);
let _e17568 = (1f - _e17566);
let _e17571 = select(_e17547, 0i, (_e17547 < 0i));
let _e17572 = (_e17571 >= _e17522.member);
if _e17572 {
phi_35286_ = (_e17522.member - 1i);
} else {
phi_35286_ = _e17571;
}
let _e17575 = phi_35286_;
let _e17577 = select(_e17562, 0i, (_e17562 < 0i));
let _e17578 = (_e17577 >= _e17522.member_1);
if _e17578 {
phi_35297_ = (_e17522.member_1 - 1i);
} else {
phi_35297_ = _e17577;
}
let _e17581 = phi_35297_;
let _e17585 = (((f32(_e17575) + 0.5f) * _e17527) - 0.5f);
let _e17589 = (((f32(_e17581) + 0.5f) * _e17527) - 0.5f);
if _e487 {
phi_35325_ = type_26(_e17581, _e17575);
} else {
phi_35325_ = type_26(_e17575, _e17581);
}
let _e17595 = phi_35325_;
let _e17601 = bitcast<i32>(((_e11943 + 1u) >> bitcast<u32>(1u)));
let _e17604 = global_1.member.member_18.member_6;
let _e17607 = global_1.member.member_18.member_7;
let _e17610 = global_1.member.member_18.member_8;
let _e17611 = (_e17505 == 0u);
if _e17611 {
phi_35376_ = 0u;
} else {
if (_e17505 == 1u) {
phi_35375_ = 0u;
} else {
if (_e17505 == 2u) {
phi_35374_ = _e17604;
} else {
phi_35374_ = select(_e17610, _e17607, (_e17505 == 3u));
}
let _e17617 = phi_35374_;
phi_35375_ = _e17617;
}
let _e17619 = phi_35375_;
phi_35376_ = _e17619;
}
let _e17621 = phi_35376_;
local_120 = (((bitcast<i32>(_e17621) + _e17595.member_1) * _e17601) + _e17595.member);
let _e17626 = local_120;
let _e17628 = (bitcast<i32>(_e296) - 1i);
let _e17630 = select(_e17628, _e17626, (_e17626 < _e17628));
let _e17635 = global_6.member[bitcast<u32>(select(0i, _e17630, (_e17630 > 0i)))];
let _e17640 = (((((select(_e17585, _e17589, _e487) + 0.5f) / _e16735) * 2f) - 1f) * _e16743);
let _e17645 = ((1f - (((select(_e17589, _e17585, _e487) + 0.5f) / _e16736) * 2f)) * _e16751);
let _e17652 = ((_e16754.member * _e17640) + (_e16762.member * _e17645));
let _e17653 = ((_e16754.member_1 * _e17640) + (_e16762.member_1 * _e17645));
let _e17654 = ((_e16754.member_2 * _e17640) + (_e16762.member_2 * _e17645));
let _e17658 = select((_e16777.member + _e17652), _e16777.member, _e16775);
let _e17659 = select((_e16777.member_1 + _e17653), _e16777.member_1, _e16775);
let _e17660 = select((_e16777.member_2 + _e17654), _e16777.member_2, _e16775);
let _e17671 = (((_e17658 * _e17658) + (_e17659 * _e17659)) + (_e17660 * _e17660));
let _e17675 = (1f / sqrt(select(0f, _e17671, (_e17671 > 0f))));
let _e17676 = (_e17658 * _e17675);
let _e17677 = (_e17659 * _e17675);
let _e17678 = (_e17660 * _e17675);
let _e17679 = (_e609 - select(_e16788.member, (_e16788.member + _e17652), _e16775));
let _e17680 = (_e621 - select(_e16788.member_1, (_e16788.member_1 + _e17653), _e16775));
let _e17681 = (_e634 - select(_e16788.member_2, (_e16788.member_2 + _e17654), _e16775));
let _e17686 = (((_e17679 * _e17676) + (_e17680 * _e17677)) + (_e17681 * _e17678));
let _e17691 = (((_e17679 * _e647) + (_e17680 * _e660)) + (_e17681 * _e673));
let _e17696 = (((_e17676 * _e647) + (_e17677 * _e660)) + (_e17678 * _e673));
let _e17699 = ((_e17677 * _e673) - (_e17678 * _e660));
let _e17702 = ((_e17678 * _e647) - (_e17676 * _e673));
let _e17705 = ((_e17676 * _e660) - (_e17677 * _e647));
let _e17710 = (((_e17699 * _e17699) + (_e17702 * _e17702)) + (_e17705 * _e17705));
let _e17713 = (1f / select(1e-9f, _e17710, (_e17710 > 1e-9f)));
let _e17716 = ((_e17686 - (_e17696 * _e17691)) * _e17713);
let _e17719 = (((_e17696 * _e17686) - _e17691) * _e17713);
let _e17725 = select(0f, _e17716, (((_e17719 >= 0f) && (_e17719 < _e725)) && (_e17716 > 0f)));
let _e17727 = (_e17575 << bitcast<u32>(_e17506));
let _e17739 = (_e17547 + 1i);
let _e17742 = select(_e17739, 0i, (_e17739 < 0i));
let _e17743 = (_e17742 >= _e17522.member);
if _e17743 {
phi_36360_ = (_e17522.member - 1i);
} else {
phi_36360_ = _e17742;
}
let _e17746 = phi_36360_;
if _e17578 {
phi_36371_ = (_e17522.member_1 - 1i);
} else {
phi_36371_ = _e17577;
}
let _e17749 = phi_36371_;
let _e17753 = (((f32(_e17746) + 0.5f) * _e17527) - 0.5f);
let _e17757 = (((f32(_e17749) + 0.5f) * _e17527) - 0.5f);
if _e487 {
phi_36399_ = type_26(_e17749, _e17746);
} else {
phi_36399_ = type_26(_e17746, _e17749);
}
let _e17763 = phi_36399_;
if _e17611 {
phi_36450_ = 0u;
} else {
if (_e17505 == 1u) {
phi_36449_ = 0u;
} else {
if (_e17505 == 2u) {
phi_36448_ = _e17604;
} else {
phi_36448_ = select(_e17610, _e17607, (_e17505 == 3u));
}
let _e17771 = phi_36448_;
phi_36449_ = _e17771;
}
let _e17773 = phi_36449_;
phi_36450_ = _e17773;
}
let _e17775 = phi_36450_;
local_118 = (((bitcast<i32>(_e17775) + _e17763.member_1) * _e17601) + _e17763.member);
let _e17780 = local_118;
let _e17782 = select(_e17628, _e17780, (_e17780 < _e17628));
let _e17787 = global_6.member[bitcast<u32>(select(0i, _e17782, (_e17782 > 0i)))];
let _e17792 = (((((select(_e17753, _e17757, _e487) + 0.5f) / _e16735) * 2f) - 1f) * _e16743);
let _e17797 = ((1f - (((select(_e17757, _e17753, _e487) + 0.5f) / _e16736) * 2f)) * _e16751);
let _e17804 = ((_e16754.member * _e17792) + (_e16762.member * _e17797));
let _e17805 = ((_e16754.member_1 * _e17792) + (_e16762.member_1 * _e17797));
let _e17806 = ((_e16754.member_2 * _e17792) + (_e16762.member_2 * _e17797));
let _e17810 = select((_e16777.member + _e17804), _e16777.member, _e16775);
let _e17811 = select((_e16777.member_1 + _e17805), _e16777.member_1, _e16775);
let _e17812 = select((_e16777.member_2 + _e17806), _e16777.member_2, _e16775);
let _e17823 = (((_e17810 * _e17810) + (_e17811 * _e17811)) + (_e17812 * _e17812));
let _e17827 = (1f / sqrt(select(0f, _e17823, (_e17823 > 0f))));
let _e17828 = (_e17810 * _e17827);
let _e17829 = (_e17811 * _e17827);
let _e17830 = (_e17812 * _e17827);
let _e17831 = (_e609 - select(_e16788.member, (_e16788.member + _e17804), _e16775));
let _e17832 = (_e621 - select(_e16788.member_1, (_e16788.member_1 + _e17805), _e16775));
let _e17833 = (_e634 - select(_e16788.member_2, (_e16788.member_2 + _e17806), _e16775));
let _e17838 = (((_e17831 * _e17828) + (_e17832 * _e17829)) + (_e17833 * _e17830));
let _e17843 = (((_e17831 * _e647) + (_e17832 * _e660)) + (_e17833 * _e673));
let _e17848 = (((_e17828 * _e647) + (_e17829 * _e660)) + (_e17830 * _e673));
let _e17851 = ((_e17829 * _e673) - (_e17830 * _e660));
let _e17854 = ((_e17830 * _e647) - (_e17828 * _e673));
let _e17857 = ((_e17828 * _e660) - (_e17829 * _e647));
let _e17862 = (((_e17851 * _e17851) + (_e17854 * _e17854)) + (_e17857 * _e17857));
let _e17865 = (1f / select(1e-9f, _e17862, (_e17862 > 1e-9f)));
let _e17868 = ((_e17838 - (_e17848 * _e17843)) * _e17865);
let _e17871 = (((_e17848 * _e17838) - _e17843) * _e17865);
let _e17877 = select(0f, _e17868, (((_e17871 >= 0f) && (_e17871 < _e725)) && (_e17868 > 0f)));
let _e17879 = (_e17746 << bitcast<u32>(_e17506));
let _e17891 = (_e17562 + 1i);
if _e17572 {
phi_37434_ = (_e17522.member - 1i);
} else {
phi_37434_ = _e17571;
}
let _e17895 = phi_37434_;
let _e17897 = select(_e17891, 0i, (_e17891 < 0i));
let _e17898 = (_e17897 >= _e17522.member_1);
if _e17898 {
phi_37445_ = (_e17522.member_1 - 1i);
} else {
phi_37445_ = _e17897;
}
let _e17901 = phi_37445_;
let _e17905 = (((f32(_e17895) + 0.5f) * _e17527) - 0.5f);
let _e17909 = (((f32(_e17901) + 0.5f) * _e17527) - 0.5f);
if _e487 {
phi_37473_ = type_26(_e17901, _e17895);
} else {
phi_37473_ = type_26(_e17895, _e17901);
}
let _e17915 = phi_37473_;
if _e17611 {
phi_37524_ = 0u;
} else {
if (_e17505 == 1u) {
phi_37523_ = 0u;
} else {
if (_e17505 == 2u) {
phi_37522_ = _e17604;
} else {
phi_37522_ = select(_e17610, _e17607, (_e17505 == 3u));
}
let _e17923 = phi_37522_;
phi_37523_ = _e17923;
}
let _e17925 = phi_37523_;
phi_37524_ = _e17925;
}
let _e17927 = phi_37524_;
local_116 = (((bitcast<i32>(_e17927) + _e17915.member_1) * _e17601) + _e17915.member);
let _e17932 = local_116;
let _e17934 = select(_e17628, _e17932, (_e17932 < _e17628));
let _e17939 = global_6.member[bitcast<u32>(select(0i, _e17934, (_e17934 > 0i)))];
let _e17944 = (((((select(_e17905, _e17909, _e487) + 0.5f) / _e16735) * 2f) - 1f) * _e16743);
let _e17949 = ((1f - (((select(_e17909, _e17905, _e487) + 0.5f) / _e16736) * 2f)) * _e16751);
let _e17956 = ((_e16754.member * _e17944) + (_e16762.member * _e17949));
let _e17957 = ((_e16754.member_1 * _e17944) + (_e16762.member_1 * _e17949));
let _e17958 = ((_e16754.member_2 * _e17944) + (_e16762.member_2 * _e17949));
let _e17962 = select((_e16777.member + _e17956), _e16777.member, _e16775);
let _e17963 = select((_e16777.member_1 + _e17957), _e16777.member_1, _e16775);
let _e17964 = select((_e16777.member_2 + _e17958), _e16777.member_2, _e16775);
let _e17975 = (((_e17962 * _e17962) + (_e17963 * _e17963)) + (_e17964 * _e17964));
let _e17979 = (1f / sqrt(select(0f, _e17975, (_e17975 > 0f))));
let _e17980 = (_e17962 * _e17979);
let _e17981 = (_e17963 * _e17979);
let _e17982 = (_e17964 * _e17979);
let _e17983 = (_e609 - select(_e16788.member, (_e16788.member + _e17956), _e16775));
let _e17984 = (_e621 - select(_e16788.member_1, (_e16788.member_1 + _e17957), _e16775));
let _e17985 = (_e634 - select(_e16788.member_2, (_e16788.member_2 + _e17958), _e16775));
let _e17990 = (((_e17983 * _e17980) + (_e17984 * _e17981)) + (_e17985 * _e17982));
let _e17995 = (((_e17983 * _e647) + (_e17984 * _e660)) + (_e17985 * _e673));
let _e18000 = (((_e17980 * _e647) + (_e17981 * _e660)) + (_e17982 * _e673));
let _e18003 = ((_e17981 * _e673) - (_e17982 * _e660));
let _e18006 = ((_e17982 * _e647) - (_e17980 * _e673));
let _e18009 = ((_e17980 * _e660) - (_e17981 * _e647));
let _e18014 = (((_e18003 * _e18003) + (_e18006 * _e18006)) + (_e18009 * _e18009));
let _e18017 = (1f / select(1e-9f, _e18014, (_e18014 > 1e-9f)));
let _e18020 = ((_e17990 - (_e18000 * _e17995)) * _e18017);
let _e18023 = (((_e18000 * _e17990) - _e17995) * _e18017);
let _e18029 = select(0f, _e18020, (((_e18023 >= 0f) && (_e18023 < _e725)) && (_e18020 > 0f)));
let _e18031 = (_e17895 << bitcast<u32>(_e17506));
if _e17743 {
phi_38508_ = (_e17522.member - 1i);
} else {
phi_38508_ = _e17742;
}
let _e18046 = phi_38508_;
if _e17898 {
phi_38519_ = (_e17522.member_1 - 1i);
} else {
phi_38519_ = _e17897;
}
let _e18049 = phi_38519_;
let _e18053 = (((f32(_e18046) + 0.5f) * _e17527) - 0.5f);
let _e18057 = (((f32(_e18049) + 0.5f) * _e17527) - 0.5f);
if _e487 {
phi_38547_ = type_26(_e18049, _e18046);
} else {
phi_38547_ = type_26(_e18046, _e18049);
}
let _e18063 = phi_38547_;
if _e17611 {
phi_38598_ = 0u;
} else {
if (_e17505 == 1u) {
phi_38597_ = 0u;
} else {
if (_e17505 == 2u) {
phi_38596_ = _e17604;
} else {
phi_38596_ = select(_e17610, _e17607, (_e17505 == 3u));
}
let _e18071 = phi_38596_;
phi_38597_ = _e18071;
}
let _e18073 = phi_38597_;
phi_38598_ = _e18073;
}
let _e18075 = phi_38598_;
local_114 = (((bitcast<i32>(_e18075) + _e18063.member_1) * _e17601) + _e18063.member);
let _e18080 = local_114;
let _e18082 = select(_e17628, _e18080, (_e18080 < _e17628));
let _e18087 = global_6.member[bitcast<u32>(select(0i, _e18082, (_e18082 > 0i)))];
let _e18092 = (((((select(_e18053, _e18057, _e487) + 0.5f) / _e16735) * 2f) - 1f) * _e16743);
let _e18097 = ((1f - (((select(_e18057, _e18053, _e487) + 0.5f) / _e16736) * 2f)) * _e16751);
let _e18104 = ((_e16754.member * _e18092) + (_e16762.member * _e18097));
let _e18105 = ((_e16754.member_1 * _e18092) + (_e16762.member_1 * _e18097));
let _e18106 = ((_e16754.member_2 * _e18092) + (_e16762.member_2 * _e18097));
let _e18110 = select((_e16777.member + _e18104), _e16777.member, _e16775);
let _e18111 = select((_e16777.member_1 + _e18105), _e16777.member_1, _e16775);
let _e18112 = select((_e16777.member_2 + _e18106), _e16777.member_2, _e16775);
let _e18123 = (((_e18110 * _e18110) + (_e18111 * _e18111)) + (_e18112 * _e18112));
let _e18127 = (1f / sqrt(select(0f, _e18123, (_e18123 > 0f))));
let _e18128 = (_e18110 * _e18127);
let _e18129 = (_e18111 * _e18127);
let _e18130 = (_e18112 * _e18127);
let _e18131 = (_e609 - select(_e16788.member, (_e16788.member + _e18104), _e16775));
let _e18132 = (_e621 - select(_e16788.member_1, (_e16788.member_1 + _e18105), _e16775));
let _e18133 = (_e634 - select(_e16788.member_2, (_e16788.member_2 + _e18106), _e16775));
let _e18138 = (((_e18131 * _e18128) + (_e18132 * _e18129)) + (_e18133 * _e18130));
let _e18143 = (((_e18131 * _e647) + (_e18132 * _e660)) + (_e18133 * _e673));
let _e18148 = (((_e18128 * _e647) + (_e18129 * _e660)) + (_e18130 * _e673));
let _e18151 = ((_e18129 * _e673) - (_e18130 * _e660));
let _e18154 = ((_e18130 * _e647) - (_e18128 * _e673));
let _e18157 = ((_e18128 * _e660) - (_e18129 * _e647));
let _e18162 = (((_e18151 * _e18151) + (_e18154 * _e18154)) + (_e18157 * _e18157));
let _e18165 = (1f / select(1e-9f, _e18162, (_e18162 > 1e-9f)));
let _e18168 = ((_e18138 - (_e18148 * _e18143)) * _e18165);
let _e18171 = (((_e18148 * _e18138) - _e18143) * _e18165);
let _e18177 = select(0f, _e18168, (((_e18171 >= 0f) && (_e18171 < _e725)) && (_e18168 > 0f)));
let _e18179 = (_e18046 << bitcast<u32>(_e17506));
let _e18191 = select(((((1f - select(0f, (_e17567 * _e17568), (((select(select(_e800, _e957, (_e17727 >= _e726)), _e879, (_e17727 < _e332)) == _e17505) && (_e17725 > 0f)) && (_e17725 < _e17635)))) - select(0f, (_e17564 * _e17568), (((select(select(_e800, _e957, (_e17879 >= _e726)), _e879, (_e17879 < _e332)) == _e17505) && (_e17877 > 0f)) && (_e17877 < _e17787)))) - select(0f, (_e17567 * _e17566), (((select(select(_e800, _e957, (_e18031 >= _e726)), _e879, (_e18031 < _e332)) == _e17505) && (_e18029 > 0f)) && (_e18029 < _e17939)))) - select(0f, (_e17564 * _e17566), (((select(select(_e800, _e957, (_e18179 >= _e726)), _e879, (_e18179 < _e332)) == _e17505) && (_e18177 > 0f)) && (_e18177 < _e18087)))), 1f, _e17611);
if _e487 {
phi_39591_ = type_26(_e16640, _e16547);
} else {
phi_39591_ = type_26(_e16547, _e16640);
}
let _e18206 = phi_39591_;
let _e18209 = (_e16641 && (((_e17503 > 0f) && (_e17503 < _e16731)) && (bitcast<f32>((bitcast<u32>(_e18191) & 2147483647u)) > 1e-6f)));
let _e18212 = global_1.member.member_18.member;
let _e18213 = (((select(_e16666, (1f - _e16666), (_e16651 >= 0f)) - select(_e16685, (1f - _e16685), (_e16670 >= 0f))) * (1f / _e16648)) * _e18212);
let _e18217 = select(0f, (((((_e686 * _e17490.member) * ((1f + (_e17371 * (1f + (_e17371 * (0.5f + (_e17371 * (0.16666667f + (_e17371 * (0.041666668f + (_e17371 * (0.008333334f + (_e17371 * (0.001388889f + (_e17371 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e17366 + 127i)) << bitcast<u32>(23i))))) * _e17193) * _e18191) * _e18213), _e18209);
let _e18218 = select(0f, (((((_e699 * _e17490.member_1) * ((1f + (_e17419 * (1f + (_e17419 * (0.5f + (_e17419 * (0.16666667f + (_e17419 * (0.041666668f + (_e17419 * (0.008333334f + (_e17419 * (0.001388889f + (_e17419 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e17414 + 127i)) << bitcast<u32>(23i))))) * _e17193) * _e18191) * _e18213), _e18209);
let _e18219 = select(0f, (((((_e712 * _e17490.member_2) * ((1f + (_e17467 * (1f + (_e17467 * (0.5f + (_e17467 * (0.16666667f + (_e17467 * (0.041666668f + (_e17467 * (0.008333334f + (_e17467 * (0.001388889f + (_e17467 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e17462 + 127i)) << bitcast<u32>(23i))))) * _e17193) * _e18191) * _e18213), _e18209);
let _e18223 = (bitcast<f32>((bitcast<u32>(_e18217) & 2147483647u)) >= 1073741800f);
let _e18224 = (1f / 1048576f);
let _e18227 = ((_e18217 * select(1f, _e18224, _e18223)) + 0.5f);
let _e18229 = select(-1073741800f, _e18227, (_e18227 > -1073741800f));
let _e18231 = select(1073741800f, _e18229, (_e18229 < 1073741800f));
let _e18238 = select(0i, select(select(i32(_e18231), i32(-2147483648), (_e18231 < -2147483600f)), 2147483647i, (_e18231 > 2147483500f)), (_e18231 == _e18231));
let _e18242 = (_e18238 - select(0i, 1i, (_e18231 < f32(_e18238))));
let _e18243 = select(0i, 20i, _e18223);
let _e18247 = (bitcast<u32>(_e18242) << bitcast<u32>((_e18243 & 31i)));
let _e18254 = bitcast<u32>(((_e18242 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e18243) & 31i))));
let _e18258 = (bitcast<f32>((bitcast<u32>(_e18218) & 2147483647u)) >= 1073741800f);
let _e18261 = ((_e18218 * select(1f, _e18224, _e18258)) + 0.5f);
let _e18263 = select(-1073741800f, _e18261, (_e18261 > -1073741800f));
let _e18265 = select(1073741800f, _e18263, (_e18263 < 1073741800f));
let _e18272 = select(0i, select(select(i32(_e18265), i32(-2147483648), (_e18265 < -2147483600f)), 2147483647i, (_e18265 > 2147483500f)), (_e18265 == _e18265));
let _e18276 = (_e18272 - select(0i, 1i, (_e18265 < f32(_e18272))));
let _e18277 = select(0i, 20i, _e18258);
let _e18281 = (bitcast<u32>(_e18276) << bitcast<u32>((_e18277 & 31i)));
let _e18288 = bitcast<u32>(((_e18276 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e18277) & 31i))));
let _e18292 = (bitcast<f32>((bitcast<u32>(_e18219) & 2147483647u)) >= 1073741800f);
let _e18295 = ((_e18219 * select(1f, _e18224, _e18292)) + 0.5f);
let _e18297 = select(-1073741800f, _e18295, (_e18295 > -1073741800f));
let _e18299 = select(1073741800f, _e18297, (_e18297 < 1073741800f));
let _e18306 = select(0i, select(select(i32(_e18299), i32(-2147483648), (_e18299 < -2147483600f)), 2147483647i, (_e18299 > 2147483500f)), (_e18299 == _e18299));
let _e18310 = (_e18306 - select(0i, 1i, (_e18299 < f32(_e18306))));
let _e18311 = select(0i, 20i, _e18292);
let _e18315 = (bitcast<u32>(_e18310) << bitcast<u32>((_e18311 & 31i)));
let _e18322 = bitcast<u32>(((_e18310 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e18311) & 31i))));
let _e18327 = bitcast<i32>(bitcast<u32>((((_e18206.member_1 * _e11947) + _e18206.member) * 6i)));
if ((_e18247 | _e18254) == 0u) {
} else {
let _e18330 = bitcast<u32>(_e18327);
if (_e18330 < _e304) {
let _e18334 = atomicAdd((&global_8.member[_e18330]), _e18247);
phi_39824_ = _e18334;
} else {
phi_39824_ = 0u;
}
let _e18336 = phi_39824_;
let _e18340 = (_e18254 + select(0u, 1u, ((_e18336 + _e18247) < _e18247)));
if (_e18340 == 0u) {
} else {
let _e18342 = (_e18330 + 1u);
if (_e18342 < _e304) {
let _e18346 = atomicAdd((&global_8.member[_e18342]), _e18340);
}
}
}
if ((_e18281 | _e18288) == 0u) {
} else {
let _e18350 = bitcast<u32>((_e18327 + 2i));
if (_e18350 < _e304) {
let _e18354 = atomicAdd((&global_8.member[_e18350]), _e18281);
phi_39854_ = _e18354;
} else {
phi_39854_ = 0u;
}
let _e18356 = phi_39854_;
let _e18360 = (_e18288 + select(0u, 1u, ((_e18356 + _e18281) < _e18281)));
if (_e18360 == 0u) {
} else {
let _e18362 = (_e18350 + 1u);
if (_e18362 < _e304) {
let _e18366 = atomicAdd((&global_8.member[_e18362]), _e18360);
}
}
}
if ((_e18315 | _e18322) == 0u) {
} else {
let _e18370 = bitcast<u32>((_e18327 + 4i));
if (_e18370 < _e304) {
let _e18374 = atomicAdd((&global_8.member[_e18370]), _e18315);
phi_39884_ = _e18374;
} else {
phi_39884_ = 0u;
}
let _e18376 = phi_39884_;
let _e18380 = (_e18322 + select(0u, 1u, ((_e18376 + _e18315) < _e18315)));
if (_e18380 == 0u) {
} else {
let _e18382 = (_e18370 + 1u);
if (_e18382 < _e304) {
let _e18386 = atomicAdd((&global_8.member[_e18382]), _e18380);
}
}
}
phi_33797_ = (_e16638 + 1i);
} else {
phi_33797_ = i32();
}
let _e18389 = phi_33797_;
continue;
continuing {
phi_33796_ = _e18389;
break if !(_e16641);
}
}
phi_33643_ = (_e16544 + 1i);
} else {
phi_33643_ = i32();
}
let _e18393 = phi_33643_;
continue;
continuing {
phi_33642_ = _e18393;
break if !(_e16545);
}
}
} else {
phi_39929_ = 0i;
loop {
let _e13366 = phi_39929_;
let _e13367 = (_e13366 < 16i);
if _e13367 {
let _e13369 = (_e11992 + (_e13366 & 15i));
let _e13371 = (f32(_e13369) + 0.5f);
let _e13373 = ((_e13371 * 1f) - 0.5f);
let _e13377 = (-(((_e450 * _e13373) + _e476)) / _e463);
let _e13384 = bitcast<f32>((bitcast<u32>(((_e500 * _e13373) + ((_e513 * _e13377) + _e526))) & 2147483647u));
let _e13391 = bitcast<f32>((bitcast<u32>(((_e539 * _e13373) + ((_e552 * _e13377) + _e565))) & 2147483647u));
let _e13395 = (((0.5f * (_e13384 + _e13391)) / _e568) + _e751);
let _e13396 = (1f / 1f);
let _e13404 = ((((_e13377 + _e13395) + 0.5f) * _e13396) - 0.5f);
let _e13405 = f32(_e13348);
let _e13406 = f32(_e13346);
let _e13407 = (_e13405 - 1f);
let _e13409 = select(_e13407, _e13404, (_e13404 > _e13407));
let _e13411 = select(_e13406, _e13409, (_e13409 < _e13406));
let _e13418 = select(0i, select(select(i32(_e13411), i32(-2147483648), (_e13411 < -2147483600f)), 2147483647i, (_e13411 > 2147483500f)), (_e13411 == _e13411));
let _e13423 = (((((_e13377 - _e13395) + 0.5f) * _e13396) - 0.5f) + 1f);
let _e13424 = (_e13406 + 1f);
let _e13426 = select(_e13405, _e13423, (_e13423 > _e13405));
let _e13428 = select(_e13424, _e13426, (_e13426 < _e13424));
let _e13435 = select(0i, select(select(i32(_e13428), i32(-2147483648), (_e13428 < -2147483600f)), 2147483647i, (_e13428 > 2147483500f)), (_e13428 == _e13428));
let _e13446 = ((1e-4f * 1f) * _e568);
let _e13448 = select(_e13391, _e13384, (_e13384 > _e13391));
let _e13450 = select(_e13446, _e13448, (_e13448 > _e13446));
let _e13452 = select(_e13391, _e13384, (_e13384 < _e13391));
let _e13454 = select(_e13446, _e13452, (_e13452 > _e13446));
let _e13456 = (0.5f * (_e13450 + _e13454));
let _e13457 = (0.5f / _e13454);
let _e13458 = (1f / _e13450);
phi_40083_ = 0i;
loop {
let _e13460 = phi_40083_;
let _e13462 = (((_e13435 - select(0i, 1i, (_e13428 < f32(_e13435)))) + (_e13366 >> bitcast<u32>(4u))) + bitcast<i32>(_e13460));
let _e13463 = (_e13462 <= select(-1i, (_e13418 - select(0i, 1i, (_e13411 < f32(_e13418)))), (_e13369 <= _e11996)));
if _e13463 {
let _e13465 = (f32(_e13462) + 0.5f);
let _e13469 = ((((_e13465 * 1f) - 0.5f) - _e13377) * _e568);
let _e13470 = (_e568 * 1f);
let _e13472 = (0.5f * _e13470);
let _e13473 = (_e13469 + _e13472);
let _e13474 = -(_e13473);
let _e13477 = (_e13456 - select(_e13474, _e13473, (_e13473 > _e13474)));
let _e13479 = select(0f, _e13477, (_e13477 > 0f));
let _e13481 = select(_e13454, _e13479, (_e13479 < _e13454));
let _e13484 = (_e13477 - _e13454);
let _e13488 = (((_e13481 * (_e13481 * _e13457)) + select(0f, _e13484, (_e13484 > 0f))) * _e13458);
let _e13492 = (_e13469 - _e13472);
let _e13493 = -(_e13492);
let _e13496 = (_e13456 - select(_e13493, _e13492, (_e13492 > _e13493)));
let _e13498 = select(0f, _e13496, (_e13496 > 0f));
let _e13500 = select(_e13454, _e13498, (_e13498 < _e13454));
let _e13503 = (_e13496 - _e13454);
let _e13507 = (((_e13500 * (_e13500 * _e13457)) + select(0f, _e13503, (_e13503 > 0f))) * _e13458);
if _e487 {
phi_40188_ = type_26(_e13462, _e13369);
} else {
phi_40188_ = type_26(_e13369, _e13462);
}
let _e13516 = phi_40188_;
let _e13520 = bitcast<i32>((_e11943 * _e11946));
local_112 = _e13520;
local_113 = ((_e13516.member_1 * _e11947) + _e13516.member);
let _e13523 = local_112;
let _e13524 = local_113;
let _e13525 = (_e13523 + _e13524);
let _e13527 = (bitcast<i32>(_e293) - 1i);
let _e13529 = select(_e13527, _e13525, (_e13525 < _e13527));
let _e13534 = global_5.member[bitcast<u32>(select(0i, _e13529, (_e13529 > 0i)))];
let _e13535 = local_112;
let _e13537 = local_113;
let _e13538 = ((2i * _e13535) + _e13537);
let _e13540 = select(_e13527, _e13538, (_e13538 < _e13527));
let _e13545 = global_5.member[bitcast<u32>(select(0i, _e13540, (_e13540 > 0i)))];
let _e13546 = local_113;
let _e13548 = select(_e13527, _e13546, (_e13546 < _e13527));
let _e13553 = global_5.member[bitcast<u32>(select(0i, _e13548, (_e13548 > 0i)))];
let _e13554 = local_113;
let _e13557 = f32(_e11947);
let _e13558 = f32(_e11948);
let _e13565 = global_1.member.member_2.member;
let _e13566 = (((((f32(_e13516.member) + 0.5f) / _e13557) * 2f) - 1f) * _e13565);
let _e13573 = global_1.member.member_2.member_1;
let _e13574 = ((1f - (((f32(_e13516.member_1) + 0.5f) / _e13558) * 2f)) * _e13573);
let _e13576 = global_1.member.member_3;
let _e13584 = global_1.member.member_4;
let _e13591 = ((_e13576.member * _e13566) + (_e13584.member * _e13574));
let _e13592 = ((_e13576.member_1 * _e13566) + (_e13584.member_1 * _e13574));
let _e13593 = ((_e13576.member_2 * _e13566) + (_e13584.member_2 * _e13574));
let _e13596 = global_1.member.member_2.member_3;
let _e13597 = (_e13596 != 0u);
let _e13599 = global_1.member.member_5;
let _e13606 = select((_e13599.member + _e13591), _e13599.member, _e13597);
let _e13607 = select((_e13599.member_1 + _e13592), _e13599.member_1, _e13597);
let _e13608 = select((_e13599.member_2 + _e13593), _e13599.member_2, _e13597);
let _e13610 = global_1.member.member_6;
let _e13617 = select(_e13610.member, (_e13610.member + _e13591), _e13597);
let _e13618 = select(_e13610.member_1, (_e13610.member_1 + _e13592), _e13597);
let _e13619 = select(_e13610.member_2, (_e13610.member_2 + _e13593), _e13597);
let _e13624 = (((_e13606 * _e13606) + (_e13607 * _e13607)) + (_e13608 * _e13608));
let _e13627 = sqrt(select(0f, _e13624, (_e13624 > 0f)));
let _e13628 = (1f / _e13627);
let _e13629 = (_e13606 * _e13628);
let _e13630 = (_e13607 * _e13628);
let _e13631 = (_e13608 * _e13628);
let _e13632 = (_e609 - _e13617);
let _e13633 = (_e621 - _e13618);
let _e13634 = (_e634 - _e13619);
let _e13639 = (((_e13632 * _e13629) + (_e13633 * _e13630)) + (_e13634 * _e13631));
let _e13644 = (((_e13632 * _e647) + (_e13633 * _e660)) + (_e13634 * _e673));
let _e13649 = (((_e13629 * _e647) + (_e13630 * _e660)) + (_e13631 * _e673));
let _e13652 = ((_e13630 * _e673) - (_e13631 * _e660));
let _e13655 = ((_e13631 * _e647) - (_e13629 * _e673));
let _e13658 = ((_e13629 * _e660) - (_e13630 * _e647));
let _e13663 = (((_e13652 * _e13652) + (_e13655 * _e13655)) + (_e13658 * _e13658));
let _e13666 = (1f / select(1e-9f, _e13663, (_e13663 > 1e-9f)));
let _e13669 = ((_e13639 - (_e13649 * _e13644)) * _e13666);
let _e13672 = (((_e13649 * _e13639) - _e13644) * _e13666);
let _e13678 = -(_e13649);
let _e13681 = global_1.member.member_13.member_2;
let _e13682 = (_e13681 * _e13681);
let _e13686 = ((1f + _e13682) - ((2f * _e13681) * _e13678));
let _e13688 = select(1e-9f, _e13686, (_e13686 > 1e-9f));
let _e13700 = global_1.member.member_13.member_3;
if (_e13700 == 2u) {
let _e13705 = (0.5f - (0.5f * _e13678));
let _e13707 = select(0f, _e13705, (_e13705 > 0f));
let _e13711 = (sqrt(select(0f, _e13707, (_e13707 > 0f))) * 255f);
let _e13712 = (255f - 1f);
let _e13714 = select(0f, _e13711, (_e13711 > 0f));
let _e13716 = select(_e13712, _e13714, (_e13714 < _e13712));
let _e13723 = select(0i, select(select(i32(_e13716), i32(-2147483648), (_e13716 < -2147483600f)), 2147483647i, (_e13716 > 2147483500f)), (_e13716 == _e13716));
let _e13727 = (_e13723 - select(0i, 1i, (_e13716 < f32(_e13723))));
let _e13730 = global_1.member.member_13.member_11;
let _e13731 = bitcast<i32>(_e13730);
let _e13732 = (_e13731 + _e13727);
let _e13734 = (bitcast<i32>(_e299) - 1i);
let _e13736 = select(_e13734, _e13732, (_e13732 < _e13734));
let _e13741 = global_2.member[bitcast<u32>(select(0i, _e13736, (_e13736 > 0i)))];
let _e13743 = (_e13731 + (_e13727 + 1i));
let _e13745 = select(_e13734, _e13743, (_e13743 < _e13734));
let _e13750 = global_2.member[bitcast<u32>(select(0i, _e13745, (_e13745 > 0i)))];
phi_40615_ = (_e13741 + ((_e13750 - _e13741) * (_e13711 - f32(_e13727))));
} else {
phi_40615_ = select(((1f - _e13682) / (_e13688 * sqrt(select(0f, _e13688, (_e13688 > 0f))))), (0.75f * (1f + (_e13678 * _e13678))), (_e13700 == 1u));
}
let _e13757 = phi_40615_;
let _e13769 = global_1.member.member_13.member_7;
let _e13770 = bitcast<i32>(_e13769);
let _e13773 = global_1.member.member_13.member_8;
let _e13774 = bitcast<i32>(_e13773);
let _e13777 = global_1.member.member_13.member_9;
let _e13778 = bitcast<i32>(_e13777);
let _e13781 = global_1.member.member_13.member_4;
let _e13787 = global_1.member.member_13.member_5;
let _e13791 = f32(_e13770);
let _e13796 = (((((_e13617 + (_e13629 * _e13669)) - _e13781.member) / (_e13787.member - _e13781.member)) * _e13791) - 0.5f);
let _e13797 = (_e13791 - 1f);
let _e13799 = select(0f, _e13796, (_e13796 > 0f));
let _e13801 = select(_e13797, _e13799, (_e13799 < _e13797));
let _e13802 = f32(_e13774);
let _e13807 = (((((_e13618 + (_e13630 * _e13669)) - _e13781.member_1) / (_e13787.member_1 - _e13781.member_1)) * _e13802) - 0.5f);
let _e13808 = (_e13802 - 1f);
let _e13810 = select(0f, _e13807, (_e13807 > 0f));
let _e13812 = select(_e13808, _e13810, (_e13810 < _e13808));
let _e13813 = f32(_e13778);
let _e13818 = (((((_e13619 + (_e13631 * _e13669)) - _e13781.member_2) / (_e13787.member_2 - _e13781.member_2)) * _e13813) - 0.5f);
let _e13819 = (_e13813 - 1f);
let _e13821 = select(0f, _e13818, (_e13818 > 0f));
let _e13823 = select(_e13819, _e13821, (_e13821 < _e13819));
let _e13825 = select(0f, _e13801, (_e13801 > 0f));
let _e13827 = select(1e6f, _e13825, (_e13825 < 1e6f));
let _e13834 = select(0i, select(select(i32(_e13827), i32(-2147483648), (_e13827 < -2147483600f)), 2147483647i, (_e13827 > 2147483500f)), (_e13827 == _e13827));
let _e13838 = (_e13834 - select(0i, 1i, (_e13827 < f32(_e13834))));
let _e13840 = select(0f, _e13812, (_e13812 > 0f));
let _e13842 = select(1e6f, _e13840, (_e13840 < 1e6f));
let _e13849 = select(0i, select(select(i32(_e13842), i32(-2147483648), (_e13842 < -2147483600f)), 2147483647i, (_e13842 > 2147483500f)), (_e13842 == _e13842));
let _e13853 = (_e13849 - select(0i, 1i, (_e13842 < f32(_e13849))));
let _e13855 = select(0f, _e13823, (_e13823 > 0f));
let _e13857 = select(1e6f, _e13855, (_e13855 < 1e6f));
let _e13864 = select(0i, select(select(i32(_e13857), i32(-2147483648), (_e13857 < -2147483600f)), 2147483647i, (_e13857 > 2147483500f)), (_e13857 == _e13857));
let _e13868 = (_e13864 - select(0i, 1i, (_e13857 < f32(_e13864))));
let _e13872 = (_e13812 - f32(_e13853));
let _e13874 = (_e13823 - f32(_e13868));
local_110 = (_e13801 - f32(_e13838));
let _e13875 = (_e13838 + 1i);
let _e13877 = select(_e13875, 0i, (_e13875 < 0i));
if (_e13877 >= _e13770) {
phi_40747_ = (_e13770 - 1i);
} else {
phi_40747_ = _e13877;
}
let _e13881 = phi_40747_;
local_111 = (_e13881 - _e13838);
let _e13883 = (_e13853 + 1i);
let _e13885 = select(_e13883, 0i, (_e13883 < 0i));
if (_e13885 >= _e13774) {
phi_40760_ = (_e13774 - 1i);
} else {
phi_40760_ = _e13885;
}
let _e13889 = phi_40760_;
let _e13891 = ((_e13889 - _e13853) * _e13770);
let _e13892 = (_e13868 + 1i);
let _e13894 = select(_e13892, 0i, (_e13892 < 0i));
if (_e13894 >= _e13778) {
phi_40774_ = (_e13778 - 1i);
} else {
phi_40774_ = _e13894;
}
let _e13898 = phi_40774_;
let _e13904 = global_1.member.member_13.member_10;
let _e13910 = ((bitcast<i32>(_e13904) + (((_e13868 * _e13774) + _e13853) * _e13770)) + _e13838);
let _e13912 = (bitcast<i32>(_e299) - 1i);
let _e13914 = select(_e13912, _e13910, (_e13910 < _e13912));
let _e13919 = global_2.member[bitcast<u32>(select(0i, _e13914, (_e13914 > 0i)))];
let _e13920 = local_110;
let _e13923 = local_111;
let _e13924 = (_e13910 + _e13923);
let _e13926 = select(_e13912, _e13924, (_e13924 < _e13912));
let _e13931 = global_2.member[bitcast<u32>(select(0i, _e13926, (_e13926 > 0i)))];
let _e13932 = local_110;
let _e13935 = (1f - _e13872);
let _e13937 = (_e13910 + _e13891);
let _e13939 = select(_e13912, _e13937, (_e13937 < _e13912));
let _e13944 = global_2.member[bitcast<u32>(select(0i, _e13939, (_e13939 > 0i)))];
let _e13945 = local_110;
let _e13948 = local_111;
let _e13949 = (_e13937 + _e13948);
let _e13951 = select(_e13912, _e13949, (_e13949 < _e13912));
let _e13956 = global_2.member[bitcast<u32>(select(0i, _e13951, (_e13951 > 0i)))];
let _e13957 = local_110;
let _e13962 = (_e13910 + (((_e13898 - _e13868) * _e13770) * _e13774));
let _e13964 = select(_e13912, _e13962, (_e13962 < _e13912));
let _e13969 = global_2.member[bitcast<u32>(select(0i, _e13964, (_e13964 > 0i)))];
let _e13970 = local_110;
let _e13973 = local_111;
let _e13974 = (_e13962 + _e13973);
let _e13976 = select(_e13912, _e13974, (_e13974 < _e13912));
let _e13981 = global_2.member[bitcast<u32>(select(0i, _e13976, (_e13976 > 0i)))];
let _e13982 = local_110;
let _e13986 = (_e13962 + _e13891);
let _e13988 = select(_e13912, _e13986, (_e13986 < _e13912));
let _e13993 = global_2.member[bitcast<u32>(select(0i, _e13988, (_e13988 > 0i)))];
let _e13994 = local_110;
let _e13997 = local_111;
let _e13998 = (_e13986 + _e13997);
let _e14000 = select(_e13912, _e13998, (_e13998 < _e13912));
let _e14005 = global_2.member[bitcast<u32>(select(0i, _e14000, (_e14000 > 0i)))];
let _e14006 = local_110;
let _e14015 = ((_e13627 * (_e13757 * (0.25f / 3.1415927f))) * ((((((_e13919 * (1f - _e13920)) + (_e13931 * _e13932)) * _e13935) + (((_e13944 * (1f - _e13945)) + (_e13956 * _e13957)) * _e13872)) * (1f - _e13874)) + (((((_e13969 * (1f - _e13970)) + (_e13981 * _e13982)) * _e13935) + (((_e13993 * (1f - _e13994)) + (_e14005 * _e14006)) * _e13872)) * _e13874)));
let _e14018 = global_1.member.member_12.member_12;
let _e14021 = global_1.member.member_12.member_4;
let _e14024 = global_1.member.member_12.member_13;
let _e14030 = global_1.member.member.member;
let _e14032 = (_e13672 / _e725);
local_107 = bitcast<i32>((_e14018 + (_e14021 * _e14024)));
local_108 = _e315;
local_109 = bitcast<i32>(_e14030);
let _e14035 = global_1.member.member_13.member_6;
let _e14036 = f32(_e14035);
let _e14038 = select(0f, _e14032, (_e14032 > 0f));
let _e14041 = (select(1f, _e14038, (_e14038 < 1f)) * _e14036);
let _e14042 = (_e14036 - 1f);
let _e14044 = select(0f, _e14042, (_e14042 > 0f));
let _e14046 = select(0f, _e14041, (_e14041 > 0f));
let _e14048 = select(_e14044, _e14046, (_e14046 < _e14044));
let _e14055 = select(0i, select(select(i32(_e14048), i32(-2147483648), (_e14048 < -2147483600f)), 2147483647i, (_e14048 > 2147483500f)), (_e14048 == _e14048));
let _e14059 = (_e14055 - select(0i, 1i, (_e14048 < f32(_e14055))));
if (_e14059 > 0i) {
let _e14062 = local_107;
let _e14063 = local_109;
let _e14066 = local_108;
let _e14067 = ((_e14062 + ((_e14059 - 1i) * _e14063)) + _e14066);
let _e14069 = (bitcast<i32>(_e302) - 1i);
let _e14071 = select(_e14069, _e14067, (_e14067 < _e14069));
let _e14076 = global_7.member[bitcast<u32>(select(0i, _e14071, (_e14071 > 0i)))];
phi_41078_ = _e14076;
} else {
phi_41078_ = 0f;
}
let _e14078 = phi_41078_;
let _e14079 = local_107;
let _e14080 = local_109;
let _e14083 = local_108;
let _e14084 = ((_e14079 + (_e14059 * _e14080)) + _e14083);
let _e14086 = (bitcast<i32>(_e302) - 1i);
let _e14088 = select(_e14086, _e14084, (_e14084 < _e14086));
let _e14093 = global_7.member[bitcast<u32>(select(0i, _e14088, (_e14088 > 0i)))];
let _e14100 = (_e13545 - _e13534);
let _e14103 = ((_e13669 - _e13534) / select(1e-9f, _e14100, (_e14100 > 1e-9f)));
local_104 = 0i;
local_105 = _e13554;
local_106 = _e13520;
let _e14105 = select(0f, _e14103, (_e14103 > 0f));
let _e14108 = (select(1f, _e14105, (_e14105 < 1f)) * _e14036);
let _e14110 = select(0f, _e14108, (_e14108 > 0f));
let _e14112 = select(_e14044, _e14110, (_e14110 < _e14044));
let _e14119 = select(0i, select(select(i32(_e14112), i32(-2147483648), (_e14112 < -2147483600f)), 2147483647i, (_e14112 > 2147483500f)), (_e14112 == _e14112));
let _e14123 = (_e14119 - select(0i, 1i, (_e14112 < f32(_e14119))));
if (_e14123 > 0i) {
let _e14126 = local_104;
let _e14127 = local_106;
let _e14130 = local_105;
let _e14131 = ((_e14126 + ((_e14123 - 1i) * _e14127)) + _e14130);
let _e14133 = select(_e14086, _e14131, (_e14131 < _e14086));
let _e14138 = global_7.member[bitcast<u32>(select(0i, _e14133, (_e14133 > 0i)))];
phi_41205_ = _e14138;
} else {
phi_41205_ = 0f;
}
let _e14140 = phi_41205_;
let _e14141 = local_104;
let _e14142 = local_106;
let _e14145 = local_105;
let _e14146 = ((_e14141 + (_e14123 * _e14142)) + _e14145);
let _e14148 = select(_e14086, _e14146, (_e14146 < _e14086));
let _e14153 = global_7.member[bitcast<u32>(select(0i, _e14148, (_e14148 > 0i)))];
let _e14159 = ((_e14078 + ((_e14093 - _e14078) * (_e14041 - f32(_e14059)))) + (_e14140 + ((_e14153 - _e14140) * (_e14108 - f32(_e14123)))));
let _e14162 = global_1.member.member_13.member;
let _e14167 = -((_e14162.member * _e14159));
let _e14169 = select(-87f, _e14167, (_e14167 > -87f));
let _e14171 = select(88f, _e14169, (_e14169 < 88f));
let _e14173 = ((_e14171 * 1.442695f) + 0.5f);
let _e14175 = select(-127f, _e14173, (_e14173 > -127f));
let _e14177 = select(128f, _e14175, (_e14175 < 128f));
let _e14184 = select(0i, select(select(i32(_e14177), i32(-2147483648), (_e14177 < -2147483600f)), 2147483647i, (_e14177 > 2147483500f)), (_e14177 == _e14177));
let _e14188 = (_e14184 - select(0i, 1i, (_e14177 < f32(_e14184))));
let _e14189 = f32(_e14188);
let _e14193 = ((_e14171 - (_e14189 * 0.6933594f)) - (_e14189 * -2.1219444e-4f));
let _e14215 = -((_e14162.member_1 * _e14159));
let _e14217 = select(-87f, _e14215, (_e14215 > -87f));
let _e14219 = select(88f, _e14217, (_e14217 < 88f));
let _e14221 = ((_e14219 * 1.442695f) + 0.5f);
let _e14223 = select(-127f, _e14221, (_e14221 > -127f));
let _e14225 = select(128f, _e14223, (_e14223 < 128f));
let _e14232 = select(0i, select(select(i32(_e14225), i32(-2147483648), (_e14225 < -2147483600f)), 2147483647i, (_e14225 > 2147483500f)), (_e14225 == _e14225));
let _e14236 = (_e14232 - select(0i, 1i, (_e14225 < f32(_e14232))));
let _e14237 = f32(_e14236);
let _e14241 = ((_e14219 - (_e14237 * 0.6933594f)) - (_e14237 * -2.1219444e-4f));
let _e14263 = -((_e14162.member_2 * _e14159));
let _e14265 = select(-87f, _e14263, (_e14263 > -87f));
let _e14267 = select(88f, _e14265, (_e14265 < 88f));
let _e14269 = ((_e14267 * 1.442695f) + 0.5f);
let _e14271 = select(-127f, _e14269, (_e14269 > -127f));
let _e14273 = select(128f, _e14271, (_e14271 < 128f));
let _e14280 = select(0i, select(select(i32(_e14273), i32(-2147483648), (_e14273 < -2147483600f)), 2147483647i, (_e14273 > 2147483500f)), (_e14273 == _e14273));
let _e14284 = (_e14280 - select(0i, 1i, (_e14273 < f32(_e14280))));
let _e14285 = f32(_e14284);
let _e14289 = ((_e14267 - (_e14285 * 0.6933594f)) - (_e14285 * -2.1219444e-4f));
let _e14312 = global_1.member.member_13.member_1;
let _e14325 = select(0f, _e13669, (((_e13672 >= 0f) && (_e13672 < _e725)) && (_e13669 > 0f)));
if _e487 {
phi_41493_ = type_26(_e12011, _e12010);
} else {
phi_41493_ = type_26(_e12010, _e12011);
}
let _e14329 = phi_41493_;
let _e14334 = f32((1i << bitcast<u32>(_e11999)));
let _e14335 = (1f / _e14334);
let _e14337 = ((_e13371 * _e14335) - 0.5f);
let _e14339 = ((_e13465 * _e14335) - 0.5f);
let _e14341 = select(-1f, _e14337, (_e14337 > -1f));
let _e14343 = select(1e6f, _e14341, (_e14341 < 1e6f));
let _e14350 = select(0i, select(select(i32(_e14343), i32(-2147483648), (_e14343 < -2147483600f)), 2147483647i, (_e14343 > 2147483500f)), (_e14343 == _e14343));
let _e14354 = (_e14350 - select(0i, 1i, (_e14343 < f32(_e14350))));
let _e14356 = select(-1f, _e14339, (_e14339 > -1f));
let _e14358 = select(1e6f, _e14356, (_e14356 < 1e6f));
let _e14365 = select(0i, select(select(i32(_e14358), i32(-2147483648), (_e14358 < -2147483600f)), 2147483647i, (_e14358 > 2147483500f)), (_e14358 == _e14358));
let _e14369 = (_e14365 - select(0i, 1i, (_e14358 < f32(_e14365))));
let _e14371 = (_e14337 - f32(_e14354));
let _e14373 = (_e14339 - f32(_e14369));
let _e14374 = (1f - _e14371);
let _e14375 = (1f - _e14373);
let _e14378 = select(_e14354, 0i, (_e14354 < 0i));
let _e14379 = (_e14378 >= _e14329.member);
if _e14379 {
phi_41571_ = (_e14329.member - 1i);
} else {
phi_41571_ = _e14378;
}
let _e14382 = phi_41571_;
let _e14384 = select(_e14369, 0i, (_e14369 < 0i));
let _e14385 = (_e14384 >= _e14329.member_1);
if _e14385 {
phi_41582_ = (_e14329.member_1 - 1i);
} else {
phi_41582_ = _e14384;
}
let _e14388 = phi_41582_;
let _e14392 = (((f32(_e14382) + 0.5f) * _e14334) - 0.5f);
let _e14396 = (((f32(_e14388) + 0.5f) * _e14334) - 0.5f);
if _e487 {
phi_41610_ = type_26(_e14388, _e14382);
} else {
phi_41610_ = type_26(_e14382, _e14388);
}
let _e14402 = phi_41610_;
let _e14408 = bitcast<i32>(((_e11943 + 1u) >> bitcast<u32>(1u)));
let _e14411 = global_1.member.member_18.member_6;
let _e14414 = global_1.member.member_18.member_7;
let _e14417 = global_1.member.member_18.member_8;
if _e11998 {
phi_41661_ = 0u;
} else {
if (_e800 == 1u) {
phi_41660_ = 0u;
} else {
if (_e800 == 2u) {
phi_41659_ = _e14411;
} else {
phi_41659_ = select(_e14417, _e14414, (_e800 == 3u));
}
let _e14423 = phi_41659_;
phi_41660_ = _e14423;
}
let _e14425 = phi_41660_;
phi_41661_ = _e14425;
}
let _e14427 = phi_41661_;
local_102 = (((bitcast<i32>(_e14427) + _e14402.member_1) * _e14408) + _e14402.member);
let _e14432 = local_102;
let _e14434 = (bitcast<i32>(_e296) - 1i);
let _e14436 = select(_e14434, _e14432, (_e14432 < _e14434));
let _e14441 = global_6.member[bitcast<u32>(select(0i, _e14436, (_e14436 > 0i)))];
let _e14446 = (((((select(_e14392, _e14396, _e487) + 0.5f) / _e13557) * 2f) - 1f) * _e13565);
let _e14451 = ((1f - (((select(_e14396, _e14392, _e487) + 0.5f) / _e13558) * 2f)) * _e13573);
let _e14458 = ((_e13576.member * _e14446) + (_e13584.member * _e14451));
let _e14459 = ((_e13576.member_1 * _e14446) + (_e13584.member_1 * _e14451));
let _e14460 = ((_e13576.member_2 * _e14446) + (_e13584.member_2 * _e14451));
let _e14464 = select((_e13599.member + _e14458), _e13599.member, _e13597);
let _e14465 = select((_e13599.member_1 + _e14459), _e13599.member_1, _e13597);
let _e14466 = select((_e13599.member_2 + _e14460), _e13599.member_2, _e13597);
let _e14477 = (((_e14464 * _e14464) + (_e14465 * _e14465)) + (_e14466 * _e14466));
let _e14481 = (1f / sqrt(select(0f, _e14477, (_e14477 > 0f))));
let _e14482 = (_e14464 * _e14481);
let _e14483 = (_e14465 * _e14481);
let _e14484 = (_e14466 * _e14481);
let _e14485 = (_e609 - select(_e13610.member, (_e13610.member + _e14458), _e13597));
let _e14486 = (_e621 - select(_e13610.member_1, (_e13610.member_1 + _e14459), _e13597));
let _e14487 = (_e634 - select(_e13610.member_2, (_e13610.member_2 + _e14460), _e13597));
let _e14492 = (((_e14485 * _e14482) + (_e14486 * _e14483)) + (_e14487 * _e14484));
let _e14497 = (((_e14485 * _e647) + (_e14486 * _e660)) + (_e14487 * _e673));
let _e14502 = (((_e14482 * _e647) + (_e14483 * _e660)) + (_e14484 * _e673));
let _e14505 = ((_e14483 * _e673) - (_e14484 * _e660));
let _e14508 = ((_e14484 * _e647) - (_e14482 * _e673));
let _e14511 = ((_e14482 * _e660) - (_e14483 * _e647));
let _e14516 = (((_e14505 * _e14505) + (_e14508 * _e14508)) + (_e14511 * _e14511));
let _e14519 = (1f / select(1e-9f, _e14516, (_e14516 > 1e-9f)));
let _e14522 = ((_e14492 - (_e14502 * _e14497)) * _e14519);
let _e14525 = (((_e14502 * _e14492) - _e14497) * _e14519);
let _e14531 = select(0f, _e14522, (((_e14525 >= 0f) && (_e14525 < _e725)) && (_e14522 > 0f)));
let _e14533 = (_e14382 << bitcast<u32>(_e11999));
let _e14545 = (_e14354 + 1i);
let _e14548 = select(_e14545, 0i, (_e14545 < 0i));
let _e14549 = (_e14548 >= _e14329.member);
if _e14549 {
phi_42645_ = (_e14329.member - 1i);
} else {
phi_42645_ = _e14548;
}
let _e14552 = phi_42645_;
if _e14385 {
phi_42656_ = (_e14329.member_1 - 1i);
} else {
phi_42656_ = _e14384;
}
let _e14555 = phi_42656_;
let _e14559 = (((f32(_e14552) + 0.5f) * _e14334) - 0.5f);
let _e14563 = (((f32(_e14555) + 0.5f) * _e14334) - 0.5f);
if _e487 {
phi_42684_ = type_26(_e14555, _e14552);
} else {
phi_42684_ = type_26(_e14552, _e14555);
}
let _e14569 = phi_42684_;
if _e11998 {
phi_42735_ = 0u;
} else {
if (_e800 == 1u) {
phi_42734_ = 0u;
} else {
if (_e800 == 2u) {
phi_42733_ = _e14411;
} else {
phi_42733_ = select(_e14417, _e14414, (_e800 == 3u));
}
let _e14577 = phi_42733_;
phi_42734_ = _e14577;
}
let _e14579 = phi_42734_;
phi_42735_ = _e14579;
}
let _e14581 = phi_42735_;
local_100 = (((bitcast<i32>(_e14581) + _e14569.member_1) * _e14408) + _e14569.member);
let _e14586 = local_100;
let _e14588 = select(_e14434, _e14586, (_e14586 < _e14434));
let _e14593 = global_6.member[bitcast<u32>(select(0i, _e14588, (_e14588 > 0i)))];
let _e14598 = (((((select(_e14559, _e14563, _e487) + 0.5f) / _e13557) * 2f) - 1f) * _e13565);
let _e14603 = ((1f - (((select(_e14563, _e14559, _e487) + 0.5f) / _e13558) * 2f)) * _e13573);
let _e14610 = ((_e13576.member * _e14598) + (_e13584.member * _e14603));
let _e14611 = ((_e13576.member_1 * _e14598) + (_e13584.member_1 * _e14603));
let _e14612 = ((_e13576.member_2 * _e14598) + (_e13584.member_2 * _e14603));
let _e14616 = select((_e13599.member + _e14610), _e13599.member, _e13597);
let _e14617 = select((_e13599.member_1 + _e14611), _e13599.member_1, _e13597);
let _e14618 = select((_e13599.member_2 + _e14612), _e13599.member_2, _e13597);
let _e14629 = (((_e14616 * _e14616) + (_e14617 * _e14617)) + (_e14618 * _e14618));
let _e14633 = (1f / sqrt(select(0f, _e14629, (_e14629 > 0f))));
let _e14634 = (_e14616 * _e14633);
let _e14635 = (_e14617 * _e14633);
let _e14636 = (_e14618 * _e14633);
let _e14637 = (_e609 - select(_e13610.member, (_e13610.member + _e14610), _e13597));
let _e14638 = (_e621 - select(_e13610.member_1, (_e13610.member_1 + _e14611), _e13597));
let _e14639 = (_e634 - select(_e13610.member_2, (_e13610.member_2 + _e14612), _e13597));
let _e14644 = (((_e14637 * _e14634) + (_e14638 * _e14635)) + (_e14639 * _e14636));
let _e14649 = (((_e14637 * _e647) + (_e14638 * _e660)) + (_e14639 * _e673));
let _e14654 = (((_e14634 * _e647) + (_e14635 * _e660)) + (_e14636 * _e673));
let _e14657 = ((_e14635 * _e673) - (_e14636 * _e660));
let _e14660 = ((_e14636 * _e647) - (_e14634 * _e673));
let _e14663 = ((_e14634 * _e660) - (_e14635 * _e647));
let _e14668 = (((_e14657 * _e14657) + (_e14660 * _e14660)) + (_e14663 * _e14663));
let _e14671 = (1f / select(1e-9f, _e14668, (_e14668 > 1e-9f)));
let _e14674 = ((_e14644 - (_e14654 * _e14649)) * _e14671);
let _e14677 = (((_e14654 * _e14644) - _e14649) * _e14671);
let _e14683 = select(0f, _e14674, (((_e14677 >= 0f) && (_e14677 < _e725)) && (_e14674 > 0f)));
let _e14685 = (_e14552 << bitcast<u32>(_e11999));
let _e14697 = (_e14369 + 1i);
if _e14379 {
phi_43719_ = (_e14329.member - 1i);
} else {
phi_43719_ = _e14378;
}
let _e14701 = phi_43719_;
let _e14703 = select(_e14697, 0i, (_e14697 < 0i));
let _e14704 = (_e14703 >= _e14329.member_1);
if _e14704 {
phi_43730_ = (_e14329.member_1 - 1i);
} else {
phi_43730_ = _e14703;
}
let _e14707 = phi_43730_;
let _e14711 = (((f32(_e14701) + 0.5f) * _e14334) - 0.5f);
let _e14715 = (((f32(_e14707) + 0.5f) * _e14334) - 0.5f);
if _e487 {
phi_43758_ = type_26(_e14707, _e14701);
} else {
phi_43758_ = type_26(_e14701, _e14707);
}
let _e14721 = phi_43758_;
if _e11998 {
phi_43809_ = 0u;
} else {
if (_e800 == 1u) {
phi_43808_ = 0u;
} else {
if (_e800 == 2u) {
phi_43807_ = _e14411;
} else {
phi_43807_ = select(_e14417, _e14414, (_e800 == 3u));
}
let _e14729 = phi_43807_;
phi_43808_ = _e14729;
}
let _e14731 = phi_43808_;
phi_43809_ = _e14731;
}
let _e14733 = phi_43809_;
local_98 = (((bitcast<i32>(_e14733) + _e14721.member_1) * _e14408) + _e14721.member);
let _e14738 = local_98;
let _e14740 = select(_e14434, _e14738, (_e14738 < _e14434));
let _e14745 = global_6.member[bitcast<u32>(select(0i, _e14740, (_e14740 > 0i)))];
let _e14750 = (((((select(_e14711, _e14715, _e487) + 0.5f) / _e13557) * 2f) - 1f) * _e13565);
let _e14755 = ((1f - (((select(_e14715, _e14711, _e487) + 0.5f) / _e13558) * 2f)) * _e13573);
let _e14762 = ((_e13576.member * _e14750) + (_e13584.member * _e14755));
let _e14763 = ((_e13576.member_1 * _e14750) + (_e13584.member_1 * _e14755));
let _e14764 = ((_e13576.member_2 * _e14750) + (_e13584.member_2 * _e14755));
let _e14768 = select((_e13599.member + _e14762), _e13599.member, _e13597);
let _e14769 = select((_e13599.member_1 + _e14763), _e13599.member_1, _e13597);
let _e14770 = select((_e13599.member_2 + _e14764), _e13599.member_2, _e13597);
let _e14781 = (((_e14768 * _e14768) + (_e14769 * _e14769)) + (_e14770 * _e14770));
let _e14785 = (1f / sqrt(select(0f, _e14781, (_e14781 > 0f))));
let _e14786 = (_e14768 * _e14785);
let _e14787 = (_e14769 * _e14785);
let _e14788 = (_e14770 * _e14785);
let _e14789 = (_e609 - select(_e13610.member, (_e13610.member + _e14762), _e13597));
let _e14790 = (_e621 - select(_e13610.member_1, (_e13610.member_1 + _e14763), _e13597));
let _e14791 = (_e634 - select(_e13610.member_2, (_e13610.member_2 + _e14764), _e13597));
let _e14796 = (((_e14789 * _e14786) + (_e14790 * _e14787)) + (_e14791 * _e14788));
let _e14801 = (((_e14789 * _e647) + (_e14790 * _e660)) + (_e14791 * _e673));
let _e14806 = (((_e14786 * _e647) + (_e14787 * _e660)) + (_e14788 * _e673));
let _e14809 = ((_e14787 * _e673) - (_e14788 * _e660));
let _e14812 = ((_e14788 * _e647) - (_e14786 * _e673));
let _e14815 = ((_e14786 * _e660) - (_e14787 * _e647));
let _e14820 = (((_e14809 * _e14809) + (_e14812 * _e14812)) + (_e14815 * _e14815));
let _e14823 = (1f / select(1e-9f, _e14820, (_e14820 > 1e-9f)));
let _e14826 = ((_e14796 - (_e14806 * _e14801)) * _e14823);
let _e14829 = (((_e14806 * _e14796) - _e14801) * _e14823);
let _e14835 = select(0f, _e14826, (((_e14829 >= 0f) && (_e14829 < _e725)) && (_e14826 > 0f)));
let _e14837 = (_e14701 << bitcast<u32>(_e11999));
if _e14549 {
phi_44793_ = (_e14329.member - 1i);
} else {
phi_44793_ = _e14548;
}
let _e14852 = phi_44793_;
if _e14704 {
phi_44804_ = (_e14329.member_1 - 1i);
} else {
phi_44804_ = _e14703;
}
let _e14855 = phi_44804_;
let _e14859 = (((f32(_e14852) + 0.5f) * _e14334) - 0.5f);
let _e14863 = (((f32(_e14855) + 0.5f) * _e14334) - 0.5f);
if _e487 {
phi_44832_ = type_26(_e14855, _e14852);
} else {
phi_44832_ = type_26(_e14852, _e14855);
}
let _e14869 = phi_44832_;
if _e11998 {
phi_44883_ = 0u;
} else {
if (_e800 == 1u) {
phi_44882_ = 0u;
} else {
if (_e800 == 2u) {
phi_44881_ = _e14411;
} else {
phi_44881_ = select(_e14417, _e14414, (_e800 == 3u));
}
let _e14877 = phi_44881_;
phi_44882_ = _e14877;
}
let _e14879 = phi_44882_;
phi_44883_ = _e14879;
}
let _e14881 = phi_44883_;
local_96 = (((bitcast<i32>(_e14881) + _e14869.member_1) * _e14408) + _e14869.member);
let _e14886 = local_96;
let _e14888 = select(_e14434, _e14886, (_e14886 < _e14434));
let _e14893 = global_6.member[bitcast<u32>(select(0i, _e14888, (_e14888 > 0i)))];
let _e14898 = (((((select(_e14859, _e14863, _e487) + 0.5f) / _e13557) * 2f) - 1f) * _e13565);
let _e14903 = ((1f - (((select(_e14863, _e14859, _e487) + 0.5f) / _e13558) * 2f)) * _e13573);
let _e14910 = ((_e13576.member * _e14898) + (_e13584.member * _e14903));
let _e14911 = ((_e13576.member_1 * _e14898) + (_e13584.member_1 * _e14903));
let _e14912 = ((_e13576.member_2 * _e14898) + (_e13584.member_2 * _e14903));
let _e14916 = select((_e13599.member + _e14910), _e13599.member, _e13597);
let _e14917 = select((_e13599.member_1 + _e14911), _e13599.member_1, _e13597);
let _e14918 = select((_e13599.member_2 + _e14912), _e13599.member_2, _e13597);
let _e14929 = (((_e14916 * _e14916) + (_e14917 * _e14917)) + (_e14918 * _e14918));
let _e14933 = (1f / sqrt(select(0f, _e14929, (_e14929 > 0f))));
let _e14934 = (_e14916 * _e14933);
let _e14935 = (_e14917 * _e14933);
let _e14936 = (_e14918 * _e14933);
let _e14937 = (_e609 - select(_e13610.member, (_e13610.member + _e14910), _e13597));
let _e14938 = (_e621 - select(_e13610.member_1, (_e13610.member_1 + _e14911), _e13597));
let _e14939 = (_e634 - select(_e13610.member_2, (_e13610.member_2 + _e14912), _e13597));
let _e14944 = (((_e14937 * _e14934) + (_e14938 * _e14935)) + (_e14939 * _e14936));
let _e14949 = (((_e14937 * _e647) + (_e14938 * _e660)) + (_e14939 * _e673));
let _e14954 = (((_e14934 * _e647) + (_e14935 * _e660)) + (_e14936 * _e673));
let _e14957 = ((_e14935 * _e673) - (_e14936 * _e660));
let _e14960 = ((_e14936 * _e647) - (_e14934 * _e673));
let _e14963 = ((_e14934 * _e660) - (_e14935 * _e647));
let _e14968 = (((_e14957 * _e14957) + (_e14960 * _e14960)) + (_e14963 * _e14963));
let _e14971 = (1f / select(1e-9f, _e14968, (_e14968 > 1e-9f)));
let _e14974 = ((_e14944 - (_e14954 * _e14949)) * _e14971);
let _e14977 = (((_e14954 * _e14944) - _e14949) * _e14971);
let _e14983 = select(0f, _e14974, (((_e14977 >= 0f) && (_e14977 < _e725)) && (_e14974 > 0f)));
let _e14985 = (_e14852 << bitcast<u32>(_e11999));
let _e14997 = select(((((1f - select(0f, (_e14374 * _e14375), (((select(select(_e800, _e957, (_e14533 >= _e726)), _e879, (_e14533 < _e332)) == _e800) && (_e14531 > 0f)) && (_e14531 < _e14441)))) - select(0f, (_e14371 * _e14375), (((select(select(_e800, _e957, (_e14685 >= _e726)), _e879, (_e14685 < _e332)) == _e800) && (_e14683 > 0f)) && (_e14683 < _e14593)))) - select(0f, (_e14374 * _e14373), (((select(select(_e800, _e957, (_e14837 >= _e726)), _e879, (_e14837 < _e332)) == _e800) && (_e14835 > 0f)) && (_e14835 < _e14745)))) - select(0f, (_e14371 * _e14373), (((select(select(_e800, _e957, (_e14985 >= _e726)), _e879, (_e14985 < _e332)) == _e800) && (_e14983 > 0f)) && (_e14983 < _e14893)))), 1f, _e11998);
let _e14998 = (_e13350 & 31u);
let _e15000 = (1u << bitcast<u32>(_e14998));
let _e15009 = bitcast<i32>((((_e11943 + _e15000) - 1u) >> bitcast<u32>(_e14998)));
let _e15010 = bitcast<i32>((((_e11946 + _e15000) - 1u) >> bitcast<u32>(_e14998)));
if _e487 {
phi_45885_ = type_26(_e15010, _e15009);
} else {
phi_45885_ = type_26(_e15009, _e15010);
}
let _e15014 = phi_45885_;
let _e15019 = f32((1i << bitcast<u32>(_e14998)));
let _e15020 = (1f / _e15019);
let _e15022 = ((_e13371 * _e15020) - 0.5f);
let _e15024 = ((_e13465 * _e15020) - 0.5f);
let _e15026 = select(-1f, _e15022, (_e15022 > -1f));
let _e15028 = select(1e6f, _e15026, (_e15026 < 1e6f));
let _e15035 = select(0i, select(select(i32(_e15028), i32(-2147483648), (_e15028 < -2147483600f)), 2147483647i, (_e15028 > 2147483500f)), (_e15028 == _e15028));
let _e15039 = (_e15035 - select(0i, 1i, (_e15028 < f32(_e15035))));
let _e15041 = select(-1f, _e15024, (_e15024 > -1f));
let _e15043 = select(1e6f, _e15041, (_e15041 < 1e6f));
let _e15050 = select(0i, select(select(i32(_e15043), i32(-2147483648), (_e15043 < -2147483600f)), 2147483647i, (_e15043 > 2147483500f)), (_e15043 == _e15043));
let _e15054 = (_e15050 - select(0i, 1i, (_e15043 < f32(_e15050))));
let _e15056 = (_e15022 - f32(_e15039));
let _e15058 = (_e15024 - f32(_e15054));
let _e15059 = (1f - _e15056);
let _e15060 = (1f - _e15058);
let _e15063 = select(_e15039, 0i, (_e15039 < 0i));
let _e15064 = (_e15063 >= _e15014.member);
if _e15064 {
phi_45963_ = (_e15014.member - 1i);
} else {
phi_45963_ = _e15063;
}
let _e15067 = phi_45963_;
let _e15069 = select(_e15054, 0i, (_e15054 < 0i));
let _e15070 = (_e15069 >= _e15014.member_1);
if _e15070 {
phi_45974_ = (_e15014.member_1 - 1i);
} else {
phi_45974_ = _e15069;
}
let _e15073 = phi_45974_;
let _e15077 = (((f32(_e15067) + 0.5f) * _e15019) - 0.5f);
let _e15081 = (((f32(_e15073) + 0.5f) * _e15019) - 0.5f);
if _e487 {
phi_46002_ = type_26(_e15073, _e15067);
} else {
phi_46002_ = type_26(_e15067, _e15073);
}
let _e15087 = phi_46002_;
let _e15090 = (_e13350 == 0u);
if _e15090 {
phi_46053_ = 0u;
} else {
if (_e13350 == 1u) {
phi_46052_ = 0u;
} else {
if (_e13350 == 2u) {
phi_46051_ = _e14411;
} else {
phi_46051_ = select(_e14417, _e14414, (_e13350 == 3u));
}
let _e15096 = phi_46051_;
phi_46052_ = _e15096;
}
let _e15098 = phi_46052_;
phi_46053_ = _e15098;
}
let _e15100 = phi_46053_;
local_94 = (((bitcast<i32>(_e15100) + _e15087.member_1) * _e14408) + _e15087.member);
let _e15105 = local_94;
let _e15107 = select(_e14434, _e15105, (_e15105 < _e14434));
let _e15112 = global_6.member[bitcast<u32>(select(0i, _e15107, (_e15107 > 0i)))];
let _e15117 = (((((select(_e15077, _e15081, _e487) + 0.5f) / _e13557) * 2f) - 1f) * _e13565);
let _e15122 = ((1f - (((select(_e15081, _e15077, _e487) + 0.5f) / _e13558) * 2f)) * _e13573);
let _e15129 = ((_e13576.member * _e15117) + (_e13584.member * _e15122));
let _e15130 = ((_e13576.member_1 * _e15117) + (_e13584.member_1 * _e15122));
let _e15131 = ((_e13576.member_2 * _e15117) + (_e13584.member_2 * _e15122));
let _e15135 = select((_e13599.member + _e15129), _e13599.member, _e13597);
let _e15136 = select((_e13599.member_1 + _e15130), _e13599.member_1, _e13597);
let _e15137 = select((_e13599.member_2 + _e15131), _e13599.member_2, _e13597);
let _e15148 = (((_e15135 * _e15135) + (_e15136 * _e15136)) + (_e15137 * _e15137));
let _e15152 = (1f / sqrt(select(0f, _e15148, (_e15148 > 0f))));
let _e15153 = (_e15135 * _e15152);
let _e15154 = (_e15136 * _e15152);
let _e15155 = (_e15137 * _e15152);
let _e15156 = (_e609 - select(_e13610.member, (_e13610.member + _e15129), _e13597));
let _e15157 = (_e621 - select(_e13610.member_1, (_e13610.member_1 + _e15130), _e13597));
let _e15158 = (_e634 - select(_e13610.member_2, (_e13610.member_2 + _e15131), _e13597));
let _e15163 = (((_e15156 * _e15153) + (_e15157 * _e15154)) + (_e15158 * _e15155));
let _e15168 = (((_e15156 * _e647) + (_e15157 * _e660)) + (_e15158 * _e673));
let _e15173 = (((_e15153 * _e647) + (_e15154 * _e660)) + (_e15155 * _e673));
let _e15176 = ((_e15154 * _e673) - (_e15155 * _e660));
let _e15179 = ((_e15155 * _e647) - (_e15153 * _e673));
let _e15182 = ((_e15153 * _e660) - (_e15154 * _e647));
let _e15187 = (((_e15176 * _e15176) + (_e15179 * _e15179)) + (_e15182 * _e15182));
let _e15190 = (1f / select(1e-9f, _e15187, (_e15187 > 1e-9f)));
let _e15193 = ((_e15163 - (_e15173 * _e15168)) * _e15190);
let _e15196 = (((_e15173 * _e15163) - _e15168) * _e15190);
let _e15202 = select(0f, _e15193, (((_e15196 >= 0f) && (_e15196 < _e725)) && (_e15193 > 0f)));
let _e15204 = (_e15067 << bitcast<u32>(_e14998));
let _e15216 = (_e15039 + 1i);
let _e15219 = select(_e15216, 0i, (_e15216 < 0i));
let _e15220 = (_e15219 >= _e15014.member);
if _e15220 {
phi_47037_ = (_e15014.member - 1i);
} else {
phi_47037_ = _e15219;
}
let _e15223 = phi_47037_;
if _e15070 {
phi_47048_ = (_e15014.member_1 - 1i);
} else {
phi_47048_ = _e15069;
}
let _e15226 = phi_47048_;
let _e15230 = (((f32(_e15223) + 0.5f) * _e15019) - 0.5f);
let _e15234 = (((f32(_e15226) + 0.5f) * _e15019) - 0.5f);
if _e487 {
phi_47076_ = type_26(_e15226, _e15223);
} else {
phi_47076_ = type_26(_e15223, _e15226);
}
let _e15240 = phi_47076_;
if _e15090 {
phi_47127_ = 0u;
} else {
if (_e13350 == 1u) {
phi_47126_ = 0u;
} else {
if (_e13350 == 2u) {
phi_47125_ = _e14411;
} else {
phi_47125_ = select(_e14417, _e14414, (_e13350 == 3u));
}
let _e15248 = phi_47125_;
phi_47126_ = _e15248;
}
let _e15250 = phi_47126_;
phi_47127_ = _e15250;
}
let _e15252 = phi_47127_;
local_92 = (((bitcast<i32>(_e15252) + _e15240.member_1) * _e14408) + _e15240.member);
let _e15257 = local_92;
let _e15259 = select(_e14434, _e15257, (_e15257 < _e14434));
let _e15264 = global_6.member[bitcast<u32>(select(0i, _e15259, (_e15259 > 0i)))];
let _e15269 = (((((select(_e15230, _e15234, _e487) + 0.5f) / _e13557) * 2f) - 1f) * _e13565);
let _e15274 = ((1f - (((select(_e15234, _e15230, _e487) + 0.5f) / _e13558) * 2f)) * _e13573);
let _e15281 = ((_e13576.member * _e15269) + (_e13584.member * _e15274));
let _e15282 = ((_e13576.member_1 * _e15269) + (_e13584.member_1 * _e15274));
let _e15283 = ((_e13576.member_2 * _e15269) + (_e13584.member_2 * _e15274));
let _e15287 = select((_e13599.member + _e15281), _e13599.member, _e13597);
let _e15288 = select((_e13599.member_1 + _e15282), _e13599.member_1, _e13597);
let _e15289 = select((_e13599.member_2 + _e15283), _e13599.member_2, _e13597);
let _e15300 = (((_e15287 * _e15287) + (_e15288 * _e15288)) + (_e15289 * _e15289));
let _e15304 = (1f / sqrt(select(0f, _e15300, (_e15300 > 0f))));
let _e15305 = (_e15287 * _e15304);
let _e15306 = (_e15288 * _e15304);
let _e15307 = (_e15289 * _e15304);
let _e15308 = (_e609 - select(_e13610.member, (_e13610.member + _e15281), _e13597));
let _e15309 = (_e621 - select(_e13610.member_1, (_e13610.member_1 + _e15282), _e13597));
let _e15310 = (_e634 - select(_e13610.member_2, (_e13610.member_2 + _e15283), _e13597));
let _e15315 = (((_e15308 * _e15305) + (_e15309 * _e15306)) + (_e15310 * _e15307));
let _e15320 = (((_e15308 * _e647) + (_e15309 * _e660)) + (_e15310 * _e673));
let _e15325 = (((_e15305 * _e647) + (_e15306 * _e660)) + (_e15307 * _e673));
let _e15328 = ((_e15306 * _e673) - (_e15307 * _e660));
let _e15331 = ((_e15307 * _e647) - (_e15305 * _e673));
let _e15334 = ((_e15305 * _e660) - (_e15306 * _e647));
let _e15339 = (((_e15328 * _e15328) + (_e15331 * _e15331)) + (_e15334 * _e15334));
let _e15342 = (1f / select(1e-9f, _e15339, (_e15339 > 1e-9f)));
let _e15345 = ((_e15315 - (_e15325 * _e15320)) * _e15342);
let _e15348 = (((_e15325 * _e15315) - _e15320) * _e15342);
let _e15354 = select(0f, _e15345, (((_e15348 >= 0f) && (_e15348 < _e725)) && (_e15345 > 0f)));
let _e15356 = (_e15223 << bitcast<u32>(_e14998));
let _e15368 = (_e15054 + 1i);
if _e15064 {
phi_48111_ = (_e15014.member - 1i);
} else {
phi_48111_ = _e15063;
}
let _e15372 = phi_48111_;
let _e15374 = select(_e15368, 0i, (_e15368 < 0i));
let _e15375 = (_e15374 >= _e15014.member_1);
if _e15375 {
phi_48122_ = (_e15014.member_1 - 1i);
} else {
phi_48122_ = _e15374;
}
let _e15378 = phi_48122_;
let _e15382 = (((f32(_e15372) + 0.5f) * _e15019) - 0.5f);
let _e15386 = (((f32(_e15378) + 0.5f) * _e15019) - 0.5f);
if _e487 {
phi_48150_ = type_26(_e15378, _e15372);
} else {
phi_48150_ = type_26(_e15372, _e15378);
}
let _e15392 = phi_48150_;
if _e15090 {
phi_48201_ = 0u;
} else {
if (_e13350 == 1u) {
phi_48200_ = 0u;
} else {
if (_e13350 == 2u) {
phi_48199_ = _e14411;
} else {
phi_48199_ = select(_e14417, _e14414, (_e13350 == 3u));
}
let _e15400 = phi_48199_;
phi_48200_ = _e15400;
}
let _e15402 = phi_48200_;
phi_48201_ = _e15402;
}
let _e15404 = phi_48201_;
local_90 = (((bitcast<i32>(_e15404) + _e15392.member_1) * _e14408) + _e15392.member);
let _e15409 = local_90;
let _e15411 = select(_e14434, _e15409, (_e15409 < _e14434));
let _e15416 = global_6.member[bitcast<u32>(select(0i, _e15411, (_e15411 > 0i)))];
let _e15421 = (((((select(_e15382, _e15386, _e487) + 0.5f) / _e13557) * 2f) - 1f) * _e13565);
let _e15426 = ((1f - (((select(_e15386, _e15382, _e487) + 0.5f) / _e13558) * 2f)) * _e13573);
let _e15433 = ((_e13576.member * _e15421) + (_e13584.member * _e15426));
let _e15434 = ((_e13576.member_1 * _e15421) + (_e13584.member_1 * _e15426));
let _e15435 = ((_e13576.member_2 * _e15421) + (_e13584.member_2 * _e15426));
let _e15439 = select((_e13599.member + _e15433), _e13599.member, _e13597);
let _e15440 = select((_e13599.member_1 + _e15434), _e13599.member_1, _e13597);
let _e15441 = select((_e13599.member_2 + _e15435), _e13599.member_2, _e13597);
let _e15452 = (((_e15439 * _e15439) + (_e15440 * _e15440)) + (_e15441 * _e15441));
let _e15456 = (1f / sqrt(select(0f, _e15452, (_e15452 > 0f))));
let _e15457 = (_e15439 * _e15456);
let _e15458 = (_e15440 * _e15456);
let _e15459 = (_e15441 * _e15456);
let _e15460 = (_e609 - select(_e13610.member, (_e13610.member + _e15433), _e13597));
let _e15461 = (_e621 - select(_e13610.member_1, (_e13610.member_1 + _e15434), _e13597));
let _e15462 = (_e634 - select(_e13610.member_2, (_e13610.member_2 + _e15435), _e13597));
let _e15467 = (((_e15460 * _e15457) + (_e15461 * _e15458)) + (_e15462 * _e15459));
let _e15472 = (((_e15460 * _e647) + (_e15461 * _e660)) + (_e15462 * _e673));
let _e15477 = (((_e15457 * _e647) + (_e15458 * _e660)) + (_e15459 * _e673));
let _e15480 = ((_e15458 * _e673) - (_e15459 * _e660));
let _e15483 = ((_e15459 * _e647) - (_e15457 * _e673));
let _e15486 = ((_e15457 * _e660) - (_e15458 * _e647));
let _e15491 = (((_e15480 * _e15480) + (_e15483 * _e15483)) + (_e15486 * _e15486));
let _e15494 = (1f / select(1e-9f, _e15491, (_e15491 > 1e-9f)));
let _e15497 = ((_e15467 - (_e15477 * _e15472)) * _e15494);
let _e15500 = (((_e15477 * _e15467) - _e15472) * _e15494);
let _e15506 = select(0f, _e15497, (((_e15500 >= 0f) && (_e15500 < _e725)) && (_e15497 > 0f)));
let _e15508 = (_e15372 << bitcast<u32>(_e14998));
if _e15220 {
phi_49185_ = (_e15014.member - 1i);
} else {
phi_49185_ = _e15219;
}
let _e15523 = phi_49185_;
if _e15375 {
phi_49196_ = (_e15014.member_1 - 1i);
} else {
phi_49196_ = _e15374;
}
let _e15526 = phi_49196_;
let _e15530 = (((f32(_e15523) + 0.5f) * _e15019) - 0.5f);
let _e15534 = (((f32(_e15526) + 0.5f) * _e15019) - 0.5f);
if _e487 {
phi_49224_ = type_26(_e15526, _e15523);
} else {
phi_49224_ = type_26(_e15523, _e15526);
}
let _e15540 = phi_49224_;
if _e15090 {
phi_49275_ = 0u;
} else {
if (_e13350 == 1u) {
phi_49274_ = 0u;
} else {
if (_e13350 == 2u) {
phi_49273_ = _e14411;
} else {
phi_49273_ = select(_e14417, _e14414, (_e13350 == 3u));
}
let _e15548 = phi_49273_;
phi_49274_ = _e15548;
}
let _e15550 = phi_49274_;
phi_49275_ = _e15550;
}
let _e15552 = phi_49275_;
local_88 = (((bitcast<i32>(_e15552) + _e15540.member_1) * _e14408) + _e15540.member);
let _e15557 = local_88;
let _e15559 = select(_e14434, _e15557, (_e15557 < _e14434));
let _e15564 = global_6.member[bitcast<u32>(select(0i, _e15559, (_e15559 > 0i)))];
let _e15569 = (((((select(_e15530, _e15534, _e487) + 0.5f) / _e13557) * 2f) - 1f) * _e13565);
let _e15574 = ((1f - (((select(_e15534, _e15530, _e487) + 0.5f) / _e13558) * 2f)) * _e13573);
let _e15581 = ((_e13576.member * _e15569) + (_e13584.member * _e15574));
let _e15582 = ((_e13576.member_1 * _e15569) + (_e13584.member_1 * _e15574));
let _e15583 = ((_e13576.member_2 * _e15569) + (_e13584.member_2 * _e15574));
let _e15587 = select((_e13599.member + _e15581), _e13599.member, _e13597);
let _e15588 = select((_e13599.member_1 + _e15582), _e13599.member_1, _e13597);
let _e15589 = select((_e13599.member_2 + _e15583), _e13599.member_2, _e13597);
let _e15600 = (((_e15587 * _e15587) + (_e15588 * _e15588)) + (_e15589 * _e15589));
let _e15604 = (1f / sqrt(select(0f, _e15600, (_e15600 > 0f))));
let _e15605 = (_e15587 * _e15604);
let _e15606 = (_e15588 * _e15604);
let _e15607 = (_e15589 * _e15604);
let _e15608 = (_e609 - select(_e13610.member, (_e13610.member + _e15581), _e13597));
let _e15609 = (_e621 - select(_e13610.member_1, (_e13610.member_1 + _e15582), _e13597));
let _e15610 = (_e634 - select(_e13610.member_2, (_e13610.member_2 + _e15583), _e13597));
let _e15615 = (((_e15608 * _e15605) + (_e15609 * _e15606)) + (_e15610 * _e15607));
let _e15620 = (((_e15608 * _e647) + (_e15609 * _e660)) + (_e15610 * _e673));
let _e15625 = (((_e15605 * _e647) + (_e15606 * _e660)) + (_e15607 * _e673));
let _e15628 = ((_e15606 * _e673) - (_e15607 * _e660));
let _e15631 = ((_e15607 * _e647) - (_e15605 * _e673));
let _e15634 = ((_e15605 * _e660) - (_e15606 * _e647));
let _e15639 = (((_e15628 * _e15628) + (_e15631 * _e15631)) + (_e15634 * _e15634));
let _e15642 = (1f / select(1e-9f, _e15639, (_e15639 > 1e-9f)));
let _e15645 = ((_e15615 - (_e15625 * _e15620)) * _e15642);
let _e15648 = (((_e15625 * _e15615) - _e15620) * _e15642);
let _e15654 = select(0f, _e15645, (((_e15648 >= 0f) && (_e15648 < _e725)) && (_e15645 > 0f)));
let _e15656 = (_e15523 << bitcast<u32>(_e14998));
let _e15668 = select(((((_e14997 - select(0f, (_e15059 * _e15060), (((select(select(_e800, _e957, (_e15204 >= _e726)), _e879, (_e15204 < _e332)) == _e13350) && (_e15202 > 0f)) && (_e15202 < _e15112)))) - select(0f, (_e15056 * _e15060), (((select(select(_e800, _e957, (_e15356 >= _e726)), _e879, (_e15356 < _e332)) == _e13350) && (_e15354 > 0f)) && (_e15354 < _e15264)))) - select(0f, (_e15059 * _e15058), (((select(select(_e800, _e957, (_e15508 >= _e726)), _e879, (_e15508 < _e332)) == _e13350) && (_e15506 > 0f)) && (_e15506 < _e15416)))) - select(0f, (_e15056 * _e15058), (((select(select(_e800, _e957, (_e15656 >= _e726)), _e879, (_e15656 < _e332)) == _e13350) && (_e15654 > 0f)) && (_e15654 < _e15564)))), _e14997, _e15090);
let _e15669 = (_e13354 & 31u);
let _e15671 = (1u << bitcast<u32>(_e15669));
let _e15680 = bitcast<i32>((((_e11943 + _e15671) - 1u) >> bitcast<u32>(_e15669)));
let _e15681 = bitcast<i32>((((_e11946 + _e15671) - 1u) >> bitcast<u32>(_e15669)));
if _e487 {
phi_50277_ = type_26(_e15681, _e15680);
} else {
phi_50277_ = type_26(_e15680, _e15681);
}
let _e15685 = phi_50277_;
let _e15690 = f32((1i << bitcast<u32>(_e15669)));
let _e15691 = (1f / _e15690);
let _e15693 = ((_e13371 * _e15691) - 0.5f);
let _e15695 = ((_e13465 * _e15691) - 0.5f);
let _e15697 = select(-1f, _e15693, (_e15693 > -1f));
let _e15699 = select(1e6f, _e15697, (_e15697 < 1e6f));
let _e15706 = select(0i, select(select(i32(_e15699), i32(-2147483648), (_e15699 < -2147483600f)), 2147483647i, (_e15699 > 2147483500f)), (_e15699 == _e15699));
let _e15710 = (_e15706 - select(0i, 1i, (_e15699 < f32(_e15706))));
let _e15712 = select(-1f, _e15695, (_e15695 > -1f));
let _e15714 = select(1e6f, _e15712, (_e15712 < 1e6f));
let _e15721 = select(0i, select(select(i32(_e15714), i32(-2147483648), (_e15714 < -2147483600f)), 2147483647i, (_e15714 > 2147483500f)), (_e15714 == _e15714));
let _e15725 = (_e15721 - select(0i, 1i, (_e15714 < f32(_e15721))));
let _e15727 = (_e15693 - f32(_e15710));
let _e15729 = (_e15695 - f32(_e15725));
let _e15730 = (1f - _e15727);
let _e15731 = (1f - _e15729);
let _e15734 = select(_e15710, 0i, (_e15710 < 0i));
let _e15735 = (_e15734 >= _e15685.member);
if _e15735 {
phi_50355_ = (_e15685.member - 1i);
} else {
phi_50355_ = _e15734;
}
let _e15738 = phi_50355_;
let _e15740 = select(_e15725, 0i, (_e15725 < 0i));
let _e15741 = (_e15740 >= _e15685.member_1);
if _e15741 {
phi_50366_ = (_e15685.member_1 - 1i);
} else {
phi_50366_ = _e15740;
}
let _e15744 = phi_50366_;
let _e15748 = (((f32(_e15738) + 0.5f) * _e15690) - 0.5f);
let _e15752 = (((f32(_e15744) + 0.5f) * _e15690) - 0.5f);
if _e487 {
phi_50394_ = type_26(_e15744, _e15738);
} else {
phi_50394_ = type_26(_e15738, _e15744);
}
let _e15758 = phi_50394_;
let _e15761 = (_e13354 == 0u);
if _e15761 {
phi_50445_ = 0u;
} else {
if (_e13354 == 1u) {
phi_50444_ = 0u;
} else {
if (_e13354 == 2u) {
phi_50443_ = _e14411;
} else {
phi_50443_ = select(_e14417, _e14414, (_e13354 == 3u));
}
let _e15767 = phi_50443_;
phi_50444_ = _e15767;
}
let _e15769 = phi_50444_;
phi_50445_ = _e15769;
}
let _e15771 = phi_50445_;
local_86 = (((bitcast<i32>(_e15771) + _e15758.member_1) * _e14408) + _e15758.member);
let _e15776 = local_86;
let _e15778 = select(_e14434, _e15776, (_e15776 < _e14434));
let _e15783 = global_6.member[bitcast<u32>(select(0i, _e15778, (_e15778 > 0i)))];
let _e15788 = (((((select(_e15748, _e15752, _e487) + 0.5f) / _e13557) * 2f) - 1f) * _e13565);
let _e15793 = ((1f - (((select(_e15752, _e15748, _e487) + 0.5f) / _e13558) * 2f)) * _e13573);
let _e15800 = ((_e13576.member * _e15788) + (_e13584.member * _e15793));
let _e15801 = ((_e13576.member_1 * _e15788) + (_e13584.member_1 * _e15793));
let _e15802 = ((_e13576.member_2 * _e15788) + (_e13584.member_2 * _e15793));
let _e15806 = select((_e13599.member + _e15800), _e13599.member, _e13597);
let _e15807 = select((_e13599.member_1 + _e15801), _e13599.member_1, _e13597);
let _e15808 = select((_e13599.member_2 + _e15802), _e13599.member_2, _e13597);
let _e15819 = (((_e15806 * _e15806) + (_e15807 * _e15807)) + (_e15808 * _e15808));
let _e15823 = (1f / sqrt(select(0f, _e15819, (_e15819 > 0f))));
let _e15824 = (_e15806 * _e15823);
let _e15825 = (_e15807 * _e15823);
let _e15826 = (_e15808 * _e15823);
let _e15827 = (_e609 - select(_e13610.member, (_e13610.member + _e15800), _e13597));
let _e15828 = (_e621 - select(_e13610.member_1, (_e13610.member_1 + _e15801), _e13597));
let _e15829 = (_e634 - select(_e13610.member_2, (_e13610.member_2 + _e15802), _e13597));
let _e15834 = (((_e15827 * _e15824) + (_e15828 * _e15825)) + (_e15829 * _e15826));
let _e15839 = (((_e15827 * _e647) + (_e15828 * _e660)) + (_e15829 * _e673));
let _e15844 = (((_e15824 * _e647) + (_e15825 * _e660)) + (_e15826 * _e673));
let _e15847 = ((_e15825 * _e673) - (_e15826 * _e660));
let _e15850 = ((_e15826 * _e647) - (_e15824 * _e673));
let _e15853 = ((_e15824 * _e660) - (_e15825 * _e647));
let _e15858 = (((_e15847 * _e15847) + (_e15850 * _e15850)) + (_e15853 * _e15853));
let _e15861 = (1f / select(1e-9f, _e15858, (_e15858 > 1e-9f)));
let _e15864 = ((_e15834 - (_e15844 * _e15839)) * _e15861);
let _e15867 = (((_e15844 * _e15834) - _e15839) * _e15861);
let _e15873 = select(0f, _e15864, (((_e15867 >= 0f) && (_e15867 < _e725)) && (_e15864 > 0f)));
let _e15875 = (_e15738 << bitcast<u32>(_e15669));
let _e15887 = (_e15710 + 1i);
let _e15890 = select(_e15887, 0i, (_e15887 < 0i));
let _e15891 = (_e15890 >= _e15685.member);
if _e15891 {
phi_51429_ = (_e15685.member - 1i);
} else {
phi_51429_ = _e15890;
}
let _e15894 = phi_51429_;
if _e15741 {
phi_51440_ = (_e15685.member_1 - 1i);
} else {
phi_51440_ = _e15740;
}
let _e15897 = phi_51440_;
let _e15901 = (((f32(_e15894) + 0.5f) * _e15690) - 0.5f);
let _e15905 = (((f32(_e15897) + 0.5f) * _e15690) - 0.5f);
if _e487 {
phi_51468_ = type_26(_e15897, _e15894);
} else {
phi_51468_ = type_26(_e15894, _e15897);
}
let _e15911 = phi_51468_;
if _e15761 {
phi_51519_ = 0u;
} else {
if (_e13354 == 1u) {
phi_51518_ = 0u;
} else {
if (_e13354 == 2u) {
phi_51517_ = _e14411;
} else {
phi_51517_ = select(_e14417, _e14414, (_e13354 == 3u));
}
let _e15919 = phi_51517_;
phi_51518_ = _e15919;
}
let _e15921 = phi_51518_;
phi_51519_ = _e15921;
}
let _e15923 = phi_51519_;
local_84 = (((bitcast<i32>(_e15923) + _e15911.member_1) * _e14408) + _e15911.member);
let _e15928 = local_84;
let _e15930 = select(_e14434, _e15928, (_e15928 < _e14434));
let _e15935 = global_6.member[bitcast<u32>(select(0i, _e15930, (_e15930 > 0i)))];
let _e15940 = (((((select(_e15901, _e15905, _e487) + 0.5f) / _e13557) * 2f) - 1f) * _e13565);
let _e15945 = ((1f - (((select(_e15905, _e15901, _e487) + 0.5f) / _e13558) * 2f)) * _e13573);
let _e15952 = ((_e13576.member * _e15940) + (_e13584.member * _e15945));
let _e15953 = ((_e13576.member_1 * _e15940) + (_e13584.member_1 * _e15945));
let _e15954 = ((_e13576.member_2 * _e15940) + (_e13584.member_2 * _e15945));
let _e15958 = select((_e13599.member + _e15952), _e13599.member, _e13597);
let _e15959 = select((_e13599.member_1 + _e15953), _e13599.member_1, _e13597);
let _e15960 = select((_e13599.member_2 + _e15954), _e13599.member_2, _e13597);
let _e15971 = (((_e15958 * _e15958) + (_e15959 * _e15959)) + (_e15960 * _e15960));
let _e15975 = (1f / sqrt(select(0f, _e15971, (_e15971 > 0f))));
let _e15976 = (_e15958 * _e15975);
let _e15977 = (_e15959 * _e15975);
let _e15978 = (_e15960 * _e15975);
let _e15979 = (_e609 - select(_e13610.member, (_e13610.member + _e15952), _e13597));
let _e15980 = (_e621 - select(_e13610.member_1, (_e13610.member_1 + _e15953), _e13597));
let _e15981 = (_e634 - select(_e13610.member_2, (_e13610.member_2 + _e15954), _e13597));
let _e15986 = (((_e15979 * _e15976) + (_e15980 * _e15977)) + (_e15981 * _e15978));
let _e15991 = (((_e15979 * _e647) + (_e15980 * _e660)) + (_e15981 * _e673));
let _e15996 = (((_e15976 * _e647) + (_e15977 * _e660)) + (_e15978 * _e673));
let _e15999 = ((_e15977 * _e673) - (_e15978 * _e660));
let _e16002 = ((_e15978 * _e647) - (_e15976 * _e673));
let _e16005 = ((_e15976 * _e660) - (_e15977 * _e647));
let _e16010 = (((_e15999 * _e15999) + (_e16002 * _e16002)) + (_e16005 * _e16005));
let _e16013 = (1f / select(1e-9f, _e16010, (_e16010 > 1e-9f)));
let _e16016 = ((_e15986 - (_e15996 * _e15991)) * _e16013);
let _e16019 = (((_e15996 * _e15986) - _e15991) * _e16013);
let _e16025 = select(0f, _e16016, (((_e16019 >= 0f) && (_e16019 < _e725)) && (_e16016 > 0f)));
let _e16027 = (_e15894 << bitcast<u32>(_e15669));
let _e16039 = (_e15725 + 1i);
if _e15735 {
phi_52503_ = (_e15685.member - 1i);
} else {
phi_52503_ = _e15734;
}
let _e16043 = phi_52503_;
let _e16045 = select(_e16039, 0i, (_e16039 < 0i));
let _e16046 = (_e16045 >= _e15685.member_1);
if _e16046 {
phi_52514_ = (_e15685.member_1 - 1i);
} else {
phi_52514_ = _e16045;
}
let _e16049 = phi_52514_;
let _e16053 = (((f32(_e16043) + 0.5f) * _e15690) - 0.5f);
let _e16057 = (((f32(_e16049) + 0.5f) * _e15690) - 0.5f);
if _e487 {
phi_52542_ = type_26(_e16049, _e16043);
} else {
phi_52542_ = type_26(_e16043, _e16049);
}
let _e16063 = phi_52542_;
if _e15761 {
phi_52593_ = 0u;
} else {
if (_e13354 == 1u) {
phi_52592_ = 0u;
} else {
if (_e13354 == 2u) {
phi_52591_ = _e14411;
} else {
phi_52591_ = select(_e14417, _e14414, (_e13354 == 3u));
}
let _e16071 = phi_52591_;
phi_52592_ = _e16071;
}
let _e16073 = phi_52592_;
phi_52593_ = _e16073;
}
let _e16075 = phi_52593_;
local_82 = (((bitcast<i32>(_e16075) + _e16063.member_1) * _e14408) + _e16063.member);
let _e16080 = local_82;
let _e16082 = select(_e14434, _e16080, (_e16080 < _e14434));
let _e16087 = global_6.member[bitcast<u32>(select(0i, _e16082, (_e16082 > 0i)))];
let _e16092 = (((((select(_e16053, _e16057, _e487) + 0.5f) / _e13557) * 2f) - 1f) * _e13565);
let _e16097 = ((1f - (((select(_e16057, _e16053, _e487) + 0.5f) / _e13558) * 2f)) * _e13573);
let _e16104 = ((_e13576.member * _e16092) + (_e13584.member * _e16097));
let _e16105 = ((_e13576.member_1 * _e16092) + (_e13584.member_1 * _e16097));
let _e16106 = ((_e13576.member_2 * _e16092) + (_e13584.member_2 * _e16097));
let _e16110 = select((_e13599.member + _e16104), _e13599.member, _e13597);
let _e16111 = select((_e13599.member_1 + _e16105), _e13599.member_1, _e13597);
let _e16112 = select((_e13599.member_2 + _e16106), _e13599.member_2, _e13597);
let _e16123 = (((_e16110 * _e16110) + (_e16111 * _e16111)) + (_e16112 * _e16112));
let _e16127 = (1f / sqrt(select(0f, _e16123, (_e16123 > 0f))));
let _e16128 = (_e16110 * _e16127);
let _e16129 = (_e16111 * _e16127);
let _e16130 = (_e16112 * _e16127);
let _e16131 = (_e609 - select(_e13610.member, (_e13610.member + _e16104), _e13597));
let _e16132 = (_e621 - select(_e13610.member_1, (_e13610.member_1 + _e16105), _e13597));
let _e16133 = (_e634 - select(_e13610.member_2, (_e13610.member_2 + _e16106), _e13597));
let _e16138 = (((_e16131 * _e16128) + (_e16132 * _e16129)) + (_e16133 * _e16130));
let _e16143 = (((_e16131 * _e647) + (_e16132 * _e660)) + (_e16133 * _e673));
let _e16148 = (((_e16128 * _e647) + (_e16129 * _e660)) + (_e16130 * _e673));
let _e16151 = ((_e16129 * _e673) - (_e16130 * _e660));
let _e16154 = ((_e16130 * _e647) - (_e16128 * _e673));
let _e16157 = ((_e16128 * _e660) - (_e16129 * _e647));
let _e16162 = (((_e16151 * _e16151) + (_e16154 * _e16154)) + (_e16157 * _e16157));
let _e16165 = (1f / select(1e-9f, _e16162, (_e16162 > 1e-9f)));
let _e16168 = ((_e16138 - (_e16148 * _e16143)) * _e16165);
let _e16171 = (((_e16148 * _e16138) - _e16143) * _e16165);
let _e16177 = select(0f, _e16168, (((_e16171 >= 0f) && (_e16171 < _e725)) && (_e16168 > 0f)));
let _e16179 = (_e16043 << bitcast<u32>(_e15669));
if _e15891 {
phi_53577_ = (_e15685.member - 1i);
} else {
phi_53577_ = _e15890;
}
let _e16194 = phi_53577_;
if _e16046 {
phi_53588_ = (_e15685.member_1 - 1i);
} else {
phi_53588_ = _e16045;
}
let _e16197 = phi_53588_;
let _e16201 = (((f32(_e16194) + 0.5f) * _e15690) - 0.5f);
let _e16205 = (((f32(_e16197) + 0.5f) * _e15690) - 0.5f);
if _e487 {
phi_53616_ = type_26(_e16197, _e16194);
} else {
phi_53616_ = type_26(_e16194, _e16197);
}
let _e16211 = phi_53616_;
if _e15761 {
phi_53667_ = 0u;
} else {
if (_e13354 == 1u) {
phi_53666_ = 0u;
} else {
if (_e13354 == 2u) {
phi_53665_ = _e14411;
} else {
phi_53665_ = select(_e14417, _e14414, (_e13354 == 3u));
}
let _e16219 = phi_53665_;
phi_53666_ = _e16219;
}
let _e16221 = phi_53666_;
phi_53667_ = _e16221;
}
let _e16223 = phi_53667_;
local_80 = (((bitcast<i32>(_e16223) + _e16211.member_1) * _e14408) + _e16211.member);
let _e16228 = local_80;
let _e16230 = select(_e14434, _e16228, (_e16228 < _e14434));
let _e16235 = global_6.member[bitcast<u32>(select(0i, _e16230, (_e16230 > 0i)))];
let _e16240 = (((((select(_e16201, _e16205, _e487) + 0.5f) / _e13557) * 2f) - 1f) * _e13565);
let _e16245 = ((1f - (((select(_e16205, _e16201, _e487) + 0.5f) / _e13558) * 2f)) * _e13573);
let _e16252 = ((_e13576.member * _e16240) + (_e13584.member * _e16245));
let _e16253 = ((_e13576.member_1 * _e16240) + (_e13584.member_1 * _e16245));
let _e16254 = ((_e13576.member_2 * _e16240) + (_e13584.member_2 * _e16245));
let _e16258 = select((_e13599.member + _e16252), _e13599.member, _e13597);
let _e16259 = select((_e13599.member_1 + _e16253), _e13599.member_1, _e13597);
let _e16260 = select((_e13599.member_2 + _e16254), _e13599.member_2, _e13597);
let _e16271 = (((_e16258 * _e16258) + (_e16259 * _e16259)) + (_e16260 * _e16260));
let _e16275 = (1f / sqrt(select(0f, _e16271, (_e16271 > 0f))));
let _e16276 = (_e16258 * _e16275);
let _e16277 = (_e16259 * _e16275);
let _e16278 = (_e16260 * _e16275);
let _e16279 = (_e609 - select(_e13610.member, (_e13610.member + _e16252), _e13597));
let _e16280 = (_e621 - select(_e13610.member_1, (_e13610.member_1 + _e16253), _e13597));
let _e16281 = (_e634 - select(_e13610.member_2, (_e13610.member_2 + _e16254), _e13597));
let _e16286 = (((_e16279 * _e16276) + (_e16280 * _e16277)) + (_e16281 * _e16278));
let _e16291 = (((_e16279 * _e647) + (_e16280 * _e660)) + (_e16281 * _e673));
let _e16296 = (((_e16276 * _e647) + (_e16277 * _e660)) + (_e16278 * _e673));
let _e16299 = ((_e16277 * _e673) - (_e16278 * _e660));
let _e16302 = ((_e16278 * _e647) - (_e16276 * _e673));
let _e16305 = ((_e16276 * _e660) - (_e16277 * _e647));
let _e16310 = (((_e16299 * _e16299) + (_e16302 * _e16302)) + (_e16305 * _e16305));
let _e16313 = (1f / select(1e-9f, _e16310, (_e16310 > 1e-9f)));
let _e16316 = ((_e16286 - (_e16296 * _e16291)) * _e16313);
let _e16319 = (((_e16296 * _e16286) - _e16291) * _e16313);
let _e16325 = select(0f, _e16316, (((_e16319 >= 0f) && (_e16319 < _e725)) && (_e16316 > 0f)));
let _e16327 = (_e16194 << bitcast<u32>(_e15669));
let _e16339 = select(((((_e15668 - select(0f, (_e15730 * _e15731), (((select(select(_e800, _e957, (_e15875 >= _e726)), _e879, (_e15875 < _e332)) == _e13354) && (_e15873 > 0f)) && (_e15873 < _e15783)))) - select(0f, (_e15727 * _e15731), (((select(select(_e800, _e957, (_e16027 >= _e726)), _e879, (_e16027 < _e332)) == _e13354) && (_e16025 > 0f)) && (_e16025 < _e15935)))) - select(0f, (_e15730 * _e15729), (((select(select(_e800, _e957, (_e16179 >= _e726)), _e879, (_e16179 < _e332)) == _e13354) && (_e16177 > 0f)) && (_e16177 < _e16087)))) - select(0f, (_e15727 * _e15729), (((select(select(_e800, _e957, (_e16327 >= _e726)), _e879, (_e16327 < _e332)) == _e13354) && (_e16325 > 0f)) && (_e16325 < _e16235)))), _e15668, _e15761);
if _e487 {
phi_54660_ = type_26(_e13462, _e13369);
} else {
phi_54660_ = type_26(_e13369, _e13462);
}
let _e16354 = phi_54660_;
let _e16357 = (_e13463 && (((_e14325 > 0f) && (_e14325 < _e13553)) && (bitcast<f32>((bitcast<u32>(_e16339) & 2147483647u)) > 1e-6f)));
let _e16360 = global_1.member.member_18.member;
let _e16361 = (((select(_e13488, (1f - _e13488), (_e13473 >= 0f)) - select(_e13507, (1f - _e13507), (_e13492 >= 0f))) * (1f / _e13470)) * _e16360);
let _e16365 = select(0f, (((((_e686 * _e14312.member) * ((1f + (_e14193 * (1f + (_e14193 * (0.5f + (_e14193 * (0.16666667f + (_e14193 * (0.041666668f + (_e14193 * (0.008333334f + (_e14193 * (0.001388889f + (_e14193 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e14188 + 127i)) << bitcast<u32>(23i))))) * _e14015) * _e16339) * _e16361), _e16357);
let _e16366 = select(0f, (((((_e699 * _e14312.member_1) * ((1f + (_e14241 * (1f + (_e14241 * (0.5f + (_e14241 * (0.16666667f + (_e14241 * (0.041666668f + (_e14241 * (0.008333334f + (_e14241 * (0.001388889f + (_e14241 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e14236 + 127i)) << bitcast<u32>(23i))))) * _e14015) * _e16339) * _e16361), _e16357);
let _e16367 = select(0f, (((((_e712 * _e14312.member_2) * ((1f + (_e14289 * (1f + (_e14289 * (0.5f + (_e14289 * (0.16666667f + (_e14289 * (0.041666668f + (_e14289 * (0.008333334f + (_e14289 * (0.001388889f + (_e14289 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e14284 + 127i)) << bitcast<u32>(23i))))) * _e14015) * _e16339) * _e16361), _e16357);
let _e16371 = (bitcast<f32>((bitcast<u32>(_e16365) & 2147483647u)) >= 1073741800f);
let _e16372 = (1f / 1048576f);
let _e16375 = ((_e16365 * select(1f, _e16372, _e16371)) + 0.5f);
let _e16377 = select(-1073741800f, _e16375, (_e16375 > -1073741800f));
let _e16379 = select(1073741800f, _e16377, (_e16377 < 1073741800f));
let _e16386 = select(0i, select(select(i32(_e16379), i32(-2147483648), (_e16379 < -2147483600f)), 2147483647i, (_e16379 > 2147483500f)), (_e16379 == _e16379));
let _e16390 = (_e16386 - select(0i, 1i, (_e16379 < f32(_e16386))));
let _e16391 = select(0i, 20i, _e16371);
let _e16395 = (bitcast<u32>(_e16390) << bitcast<u32>((_e16391 & 31i)));
let _e16402 = bitcast<u32>(((_e16390 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e16391) & 31i))));
let _e16406 = (bitcast<f32>((bitcast<u32>(_e16366) & 2147483647u)) >= 1073741800f);
let _e16409 = ((_e16366 * select(1f, _e16372, _e16406)) + 0.5f);
let _e16411 = select(-1073741800f, _e16409, (_e16409 > -1073741800f));
let _e16413 = select(1073741800f, _e16411, (_e16411 < 1073741800f));
let _e16420 = select(0i, select(select(i32(_e16413), i32(-2147483648), (_e16413 < -2147483600f)), 2147483647i, (_e16413 > 2147483500f)), (_e16413 == _e16413));
let _e16424 = (_e16420 - select(0i, 1i, (_e16413 < f32(_e16420))));
let _e16425 = select(0i, 20i, _e16406);
let _e16429 = (bitcast<u32>(_e16424) << bitcast<u32>((_e16425 & 31i)));
let _e16436 = bitcast<u32>(((_e16424 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e16425) & 31i))));
let _e16440 = (bitcast<f32>((bitcast<u32>(_e16367) & 2147483647u)) >= 1073741800f);
let _e16443 = ((_e16367 * select(1f, _e16372, _e16440)) + 0.5f);
let _e16445 = select(-1073741800f, _e16443, (_e16443 > -1073741800f));
let _e16447 = select(1073741800f, _e16445, (_e16445 < 1073741800f));
let _e16454 = select(0i, select(select(i32(_e16447), i32(-2147483648), (_e16447 < -2147483600f)), 2147483647i, (_e16447 > 2147483500f)), (_e16447 == _e16447));
let _e16458 = (_e16454 - select(0i, 1i, (_e16447 < f32(_e16454))));
let _e16459 = select(0i, 20i, _e16440);
let _e16463 = (bitcast<u32>(_e16458) << bitcast<u32>((_e16459 & 31i)));
let _e16470 = bitcast<u32>(((_e16458 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e16459) & 31i))));
let _e16475 = bitcast<i32>(bitcast<u32>((((_e16354.member_1 * _e11947) + _e16354.member) * 6i)));
if ((_e16395 | _e16402) == 0u) {
} else {
let _e16478 = bitcast<u32>(_e16475);
if (_e16478 < _e304) {
let _e16482 = atomicAdd((&global_8.member[_e16478]), _e16395);
phi_54893_ = _e16482;
} else {
phi_54893_ = 0u;
}
let _e16484 = phi_54893_;
let _e16488 = (_e16402 + select(0u, 1u, ((_e16484 + _e16395) < _e16395)));
if (_e16488 == 0u) {
} else {
let _e16490 = (_e16478 + 1u);
if (_e16490 < _e304) {
let _e16494 = atomicAdd((&global_8.member[_e16490]), _e16488);
}
}
}
if ((_e16429 | _e16436) == 0u) {
} else {
let _e16498 = bitcast<u32>((_e16475 + 2i));
if (_e16498 < _e304) {
let _e16502 = atomicAdd((&global_8.member[_e16498]), _e16429);
phi_54923_ = _e16502;
} else {
phi_54923_ = 0u;
}
let _e16504 = phi_54923_;
let _e16508 = (_e16436 + select(0u, 1u, ((_e16504 + _e16429) < _e16429)));
if (_e16508 == 0u) {
} else {
let _e16510 = (_e16498 + 1u);
if (_e16510 < _e304) {
let _e16514 = atomicAdd((&global_8.member[_e16510]), _e16508);
}
}
}
if ((_e16463 | _e16470) == 0u) {
} else {
let _e16518 = bitcast<u32>((_e16475 + 4i));
if (_e16518 < _e304) {
let _e16522 = atomicAdd((&global_8.member[_e16518]), _e16463);
phi_54953_ = _e16522;
} else {
phi_54953_ = 0u;
}
let _e16524 = phi_54953_;
let _e16528 = (_e16470 + select(0u, 1u, ((_e16524 + _e16463) < _e16463)));
if (_e16528 == 0u) {
} else {
let _e16530 = (_e16518 + 1u);
if (_e16530 < _e304) {
let _e16534 = atomicAdd((&global_8.member[_e16530]), _e16528);
}
}
}
phi_40084_ = (_e13460 + 1i);
} else {
phi_40084_ = i32();
}
let _e16537 = phi_40084_;
continue;
continuing {
phi_40083_ = _e16537;
break if !(_e13463);
}
}
phi_39930_ = (_e13366 + 1i);
} else {
phi_39930_ = i32();
}
let _e16541 = phi_39930_;
continue;
continuing {
phi_39929_ = _e16541;
break if !(_e13367);
}
}
}
}
}
}
} else {
let _e962 = global_1.member.member_1.member;
let _e965 = global_1.member.member_1.member_1;
let _e966 = bitcast<i32>(_e962);
let _e967 = bitcast<i32>(_e965);
if _e487 {
phi_55020_ = type_26(_e967, _e966);
} else {
phi_55020_ = type_26(_e966, _e967);
}
let _e971 = phi_55020_;
let _e975 = f32((_e332 + 15i));
let _e977 = select(_e975, _e412, (_e412 < _e975));
let _e979 = select(_e348, _e977, (_e977 > _e348));
let _e981 = select(_e975, _e979, (_e979 < _e975));
let _e988 = select(0i, select(select(i32(_e981), i32(-2147483648), (_e981 < -2147483600f)), 2147483647i, (_e981 > 2147483500f)), (_e981 == _e981));
let _e992 = (_e988 - select(0i, 1i, (_e981 < f32(_e988))));
let _e993 = bitcast<i32>(_e992);
let _e995 = select(_e348, _e399, (_e399 > _e348));
let _e997 = select(_e348, _e995, (_e995 > _e348));
let _e999 = select(_e975, _e997, (_e997 < _e975));
let _e1006 = select(0i, select(select(i32(_e999), i32(-2147483648), (_e999 < -2147483600f)), 2147483647i, (_e999 > 2147483500f)), (_e999 == _e999));
let _e1010 = (_e1006 - select(0i, 1i, (_e999 < f32(_e1006))));
let _e1011 = bitcast<i32>(_e1010);
if (_e993 < _e971.member) {
phi_55095_ = _e993;
} else {
phi_55095_ = (_e971.member - 1i);
}
let _e1015 = phi_55095_;
let _e1016 = (_e971.member_1 - 1i);
let _e1017 = (_e800 == 0u);
if _e1017 {
let _e6947 = select(_e879, 0u, (_e879 == _e800));
let _e6951 = select(_e957, 0u, ((_e957 == _e800) || (_e957 == _e879)));
let _e6959 = ((select(0u, 1u, (_e800 > 0u)) + select(0u, 1u, (_e6947 > 0u))) + select(0u, 1u, (_e6951 > 0u)));
if (_e6959 == 0u) {
phi_55133_ = 0i;
loop {
let _e11190 = phi_55133_;
let _e11191 = (_e11190 < 16i);
if _e11191 {
let _e11193 = (_e1011 + (_e11190 & 15i));
let _e11197 = (((f32(_e11193) + 0.5f) * 1f) - 0.5f);
let _e11201 = (-(((_e450 * _e11197) + _e476)) / _e463);
let _e11208 = bitcast<f32>((bitcast<u32>(((_e500 * _e11197) + ((_e513 * _e11201) + _e526))) & 2147483647u));
let _e11215 = bitcast<f32>((bitcast<u32>(((_e539 * _e11197) + ((_e552 * _e11201) + _e565))) & 2147483647u));
let _e11219 = (((0.5f * (_e11208 + _e11215)) / _e568) + _e751);
let _e11220 = (1f / 1f);
let _e11228 = ((((_e11201 + _e11219) + 0.5f) * _e11220) - 0.5f);
let _e11229 = f32(_e1016);
let _e11230 = (0f - 1f);
let _e11232 = select(_e11230, _e11228, (_e11228 > _e11230));
let _e11234 = select(_e11229, _e11232, (_e11232 < _e11229));
let _e11241 = select(0i, select(select(i32(_e11234), i32(-2147483648), (_e11234 < -2147483600f)), 2147483647i, (_e11234 > 2147483500f)), (_e11234 == _e11234));
let _e11246 = (((((_e11201 - _e11219) + 0.5f) * _e11220) - 0.5f) + 1f);
let _e11247 = (_e11229 + 1f);
let _e11249 = select(0f, _e11246, (_e11246 > 0f));
let _e11251 = select(_e11247, _e11249, (_e11249 < _e11247));
let _e11258 = select(0i, select(select(i32(_e11251), i32(-2147483648), (_e11251 < -2147483600f)), 2147483647i, (_e11251 > 2147483500f)), (_e11251 == _e11251));
let _e11269 = ((1e-4f * 1f) * _e568);
let _e11271 = select(_e11215, _e11208, (_e11208 > _e11215));
let _e11273 = select(_e11269, _e11271, (_e11271 > _e11269));
let _e11275 = select(_e11215, _e11208, (_e11208 < _e11215));
let _e11277 = select(_e11269, _e11275, (_e11275 > _e11269));
let _e11279 = (0.5f * (_e11273 + _e11277));
let _e11280 = (0.5f / _e11277);
let _e11281 = (1f / _e11273);
phi_55287_ = 0i;
loop {
let _e11283 = phi_55287_;
let _e11285 = (((_e11258 - select(0i, 1i, (_e11251 < f32(_e11258)))) + (_e11190 >> bitcast<u32>(4u))) + bitcast<i32>(_e11283));
let _e11286 = (_e11285 <= select(-1i, (_e11241 - select(0i, 1i, (_e11234 < f32(_e11241)))), (_e11193 <= _e1015)));
if _e11286 {
let _e11292 = (((((f32(_e11285) + 0.5f) * 1f) - 0.5f) - _e11201) * _e568);
let _e11293 = (_e568 * 1f);
let _e11295 = (0.5f * _e11293);
let _e11296 = (_e11292 + _e11295);
let _e11297 = -(_e11296);
let _e11300 = (_e11279 - select(_e11297, _e11296, (_e11296 > _e11297)));
let _e11302 = select(0f, _e11300, (_e11300 > 0f));
let _e11304 = select(_e11277, _e11302, (_e11302 < _e11277));
let _e11307 = (_e11300 - _e11277);
let _e11311 = (((_e11304 * (_e11304 * _e11280)) + select(0f, _e11307, (_e11307 > 0f))) * _e11281);
let _e11315 = (_e11292 - _e11295);
let _e11316 = -(_e11315);
let _e11319 = (_e11279 - select(_e11316, _e11315, (_e11315 > _e11316)));
let _e11321 = select(0f, _e11319, (_e11319 > 0f));
let _e11323 = select(_e11277, _e11321, (_e11321 < _e11277));
let _e11326 = (_e11319 - _e11277);
let _e11330 = (((_e11323 * (_e11323 * _e11280)) + select(0f, _e11326, (_e11326 > 0f))) * _e11281);
if _e487 {
phi_55392_ = type_26(_e11285, _e11193);
} else {
phi_55392_ = type_26(_e11193, _e11285);
}
let _e11339 = phi_55392_;
local_78 = bitcast<i32>((_e962 * _e965));
local_79 = ((_e11339.member_1 * _e966) + _e11339.member);
let _e11346 = local_78;
let _e11347 = local_79;
let _e11348 = (_e11346 + _e11347);
let _e11350 = (bitcast<i32>(_e293) - 1i);
let _e11352 = select(_e11350, _e11348, (_e11348 < _e11350));
let _e11357 = global_5.member[bitcast<u32>(select(0i, _e11352, (_e11352 > 0i)))];
let _e11358 = local_79;
let _e11360 = select(_e11350, _e11358, (_e11358 < _e11350));
let _e11365 = global_5.member[bitcast<u32>(select(0i, _e11360, (_e11360 > 0i)))];
let _e11376 = global_1.member.member_2.member;
let _e11377 = (((((f32(_e11339.member) + 0.5f) / f32(_e966)) * 2f) - 1f) * _e11376);
let _e11384 = global_1.member.member_2.member_1;
let _e11385 = ((1f - (((f32(_e11339.member_1) + 0.5f) / f32(_e967)) * 2f)) * _e11384);
let _e11387 = global_1.member.member_3;
let _e11395 = global_1.member.member_4;
let _e11402 = ((_e11387.member * _e11377) + (_e11395.member * _e11385));
let _e11403 = ((_e11387.member_1 * _e11377) + (_e11395.member_1 * _e11385));
let _e11404 = ((_e11387.member_2 * _e11377) + (_e11395.member_2 * _e11385));
let _e11407 = global_1.member.member_2.member_3;
let _e11408 = (_e11407 != 0u);
let _e11410 = global_1.member.member_5;
let _e11417 = select((_e11410.member + _e11402), _e11410.member, _e11408);
let _e11418 = select((_e11410.member_1 + _e11403), _e11410.member_1, _e11408);
let _e11419 = select((_e11410.member_2 + _e11404), _e11410.member_2, _e11408);
let _e11421 = global_1.member.member_6;
let _e11435 = (((_e11417 * _e11417) + (_e11418 * _e11418)) + (_e11419 * _e11419));
let _e11438 = sqrt(select(0f, _e11435, (_e11435 > 0f)));
let _e11439 = (1f / _e11438);
let _e11440 = (_e11417 * _e11439);
let _e11441 = (_e11418 * _e11439);
let _e11442 = (_e11419 * _e11439);
let _e11443 = (_e609 - select(_e11421.member, (_e11421.member + _e11402), _e11408));
let _e11444 = (_e621 - select(_e11421.member_1, (_e11421.member_1 + _e11403), _e11408));
let _e11445 = (_e634 - select(_e11421.member_2, (_e11421.member_2 + _e11404), _e11408));
let _e11450 = (((_e11443 * _e11440) + (_e11444 * _e11441)) + (_e11445 * _e11442));
let _e11455 = (((_e11443 * _e647) + (_e11444 * _e660)) + (_e11445 * _e673));
let _e11460 = (((_e11440 * _e647) + (_e11441 * _e660)) + (_e11442 * _e673));
let _e11463 = ((_e11441 * _e673) - (_e11442 * _e660));
let _e11466 = ((_e11442 * _e647) - (_e11440 * _e673));
let _e11469 = ((_e11440 * _e660) - (_e11441 * _e647));
let _e11474 = (((_e11463 * _e11463) + (_e11466 * _e11466)) + (_e11469 * _e11469));
let _e11477 = (1f / select(1e-9f, _e11474, (_e11474 > 1e-9f)));
let _e11480 = ((_e11450 - (_e11460 * _e11455)) * _e11477);
let _e11483 = (((_e11460 * _e11450) - _e11455) * _e11477);
let _e11489 = -(_e11460);
let _e11492 = global_1.member.member_13.member_2;
let _e11493 = (_e11492 * _e11492);
let _e11497 = ((1f + _e11493) - ((2f * _e11492) * _e11489));
let _e11499 = select(1e-9f, _e11497, (_e11497 > 1e-9f));
let _e11511 = global_1.member.member_13.member_3;
if (_e11511 == 2u) {
let _e11516 = (0.5f - (0.5f * _e11489));
let _e11518 = select(0f, _e11516, (_e11516 > 0f));
let _e11522 = (sqrt(select(0f, _e11518, (_e11518 > 0f))) * 255f);
let _e11523 = (255f - 1f);
let _e11525 = select(0f, _e11522, (_e11522 > 0f));
let _e11527 = select(_e11523, _e11525, (_e11525 < _e11523));
let _e11534 = select(0i, select(select(i32(_e11527), i32(-2147483648), (_e11527 < -2147483600f)), 2147483647i, (_e11527 > 2147483500f)), (_e11527 == _e11527));
let _e11538 = (_e11534 - select(0i, 1i, (_e11527 < f32(_e11534))));
let _e11541 = global_1.member.member_13.member_11;
let _e11542 = bitcast<i32>(_e11541);
let _e11543 = (_e11542 + _e11538);
let _e11545 = (bitcast<i32>(_e299) - 1i);
let _e11547 = select(_e11545, _e11543, (_e11543 < _e11545));
let _e11552 = global_2.member[bitcast<u32>(select(0i, _e11547, (_e11547 > 0i)))];
let _e11554 = (_e11542 + (_e11538 + 1i));
let _e11556 = select(_e11545, _e11554, (_e11554 < _e11545));
let _e11561 = global_2.member[bitcast<u32>(select(0i, _e11556, (_e11556 > 0i)))];
phi_55819_ = (_e11552 + ((_e11561 - _e11552) * (_e11522 - f32(_e11538))));
} else {
phi_55819_ = select(((1f - _e11493) / (_e11499 * sqrt(select(0f, _e11499, (_e11499 > 0f))))), (0.75f * (1f + (_e11489 * _e11489))), (_e11511 == 1u));
}
let _e11568 = phi_55819_;
let _e11571 = (_e11438 * (_e11568 * (0.25f / 3.1415927f)));
let _e11572 = (_e11480 - _e11357);
let _e11575 = (_e11483 + select(0f, _e11572, (_e11572 > 0f)));
let _e11578 = global_1.member.member_13.member;
let _e11583 = -((_e11578.member * _e11575));
let _e11585 = select(-87f, _e11583, (_e11583 > -87f));
let _e11587 = select(88f, _e11585, (_e11585 < 88f));
let _e11589 = ((_e11587 * 1.442695f) + 0.5f);
let _e11591 = select(-127f, _e11589, (_e11589 > -127f));
let _e11593 = select(128f, _e11591, (_e11591 < 128f));
let _e11600 = select(0i, select(select(i32(_e11593), i32(-2147483648), (_e11593 < -2147483600f)), 2147483647i, (_e11593 > 2147483500f)), (_e11593 == _e11593));
let _e11604 = (_e11600 - select(0i, 1i, (_e11593 < f32(_e11600))));
let _e11605 = f32(_e11604);
let _e11609 = ((_e11587 - (_e11605 * 0.6933594f)) - (_e11605 * -2.1219444e-4f));
let _e11631 = -((_e11578.member_1 * _e11575));
let _e11633 = select(-87f, _e11631, (_e11631 > -87f));
let _e11635 = select(88f, _e11633, (_e11633 < 88f));
let _e11637 = ((_e11635 * 1.442695f) + 0.5f);
let _e11639 = select(-127f, _e11637, (_e11637 > -127f));
let _e11641 = select(128f, _e11639, (_e11639 < 128f));
let _e11648 = select(0i, select(select(i32(_e11641), i32(-2147483648), (_e11641 < -2147483600f)), 2147483647i, (_e11641 > 2147483500f)), (_e11641 == _e11641));
let _e11652 = (_e11648 - select(0i, 1i, (_e11641 < f32(_e11648))));
let _e11653 = f32(_e11652);
let _e11657 = ((_e11635 - (_e11653 * 0.6933594f)) - (_e11653 * -2.1219444e-4f));
let _e11679 = -((_e11578.member_2 * _e11575));
let _e11681 = select(-87f, _e11679, (_e11679 > -87f));
let _e11683 = select(88f, _e11681, (_e11681 < 88f));
let _e11685 = ((_e11683 * 1.442695f) + 0.5f);
let _e11687 = select(-127f, _e11685, (_e11685 > -127f));
let _e11689 = select(128f, _e11687, (_e11687 < 128f));
let _e11696 = select(0i, select(select(i32(_e11689), i32(-2147483648), (_e11689 < -2147483600f)), 2147483647i, (_e11689 > 2147483500f)), (_e11689 == _e11689));
let _e11700 = (_e11696 - select(0i, 1i, (_e11689 < f32(_e11696))));
let _e11701 = f32(_e11700);
let _e11705 = ((_e11683 - (_e11701 * 0.6933594f)) - (_e11701 * -2.1219444e-4f));
let _e11728 = global_1.member.member_13.member_1;
let _e11741 = select(0f, _e11480, (((_e11483 >= 0f) && (_e11483 < _e725)) && (_e11480 > 0f)));
if _e487 {
phi_56421_ = type_26(_e11285, _e11193);
} else {
phi_56421_ = type_26(_e11193, _e11285);
}
let _e11752 = phi_56421_;
let _e11755 = (_e11286 && (((_e11741 > 0f) && (_e11741 < _e11365)) && true));
let _e11758 = global_1.member.member_18.member;
let _e11759 = (((select(_e11311, (1f - _e11311), (_e11296 >= 0f)) - select(_e11330, (1f - _e11330), (_e11315 >= 0f))) * (1f / _e11293)) * _e11758);
let _e11763 = select(0f, (((((_e686 * _e11728.member) * ((1f + (_e11609 * (1f + (_e11609 * (0.5f + (_e11609 * (0.16666667f + (_e11609 * (0.041666668f + (_e11609 * (0.008333334f + (_e11609 * (0.001388889f + (_e11609 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e11604 + 127i)) << bitcast<u32>(23i))))) * _e11571) * 1f) * _e11759), _e11755);
let _e11764 = select(0f, (((((_e699 * _e11728.member_1) * ((1f + (_e11657 * (1f + (_e11657 * (0.5f + (_e11657 * (0.16666667f + (_e11657 * (0.041666668f + (_e11657 * (0.008333334f + (_e11657 * (0.001388889f + (_e11657 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e11652 + 127i)) << bitcast<u32>(23i))))) * _e11571) * 1f) * _e11759), _e11755);
let _e11765 = select(0f, (((((_e712 * _e11728.member_2) * ((1f + (_e11705 * (1f + (_e11705 * (0.5f + (_e11705 * (0.16666667f + (_e11705 * (0.041666668f + (_e11705 * (0.008333334f + (_e11705 * (0.001388889f + (_e11705 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e11700 + 127i)) << bitcast<u32>(23i))))) * _e11571) * 1f) * _e11759), _e11755);
let _e11769 = (bitcast<f32>((bitcast<u32>(_e11763) & 2147483647u)) >= 1073741800f);
let _e11770 = (1f / 1048576f);
let _e11773 = ((_e11763 * select(1f, _e11770, _e11769)) + 0.5f);
let _e11775 = select(-1073741800f, _e11773, (_e11773 > -1073741800f));
let _e11777 = select(1073741800f, _e11775, (_e11775 < 1073741800f));
let _e11784 = select(0i, select(select(i32(_e11777), i32(-2147483648), (_e11777 < -2147483600f)), 2147483647i, (_e11777 > 2147483500f)), (_e11777 == _e11777));
let _e11788 = (_e11784 - select(0i, 1i, (_e11777 < f32(_e11784))));
let _e11789 = select(0i, 20i, _e11769);
let _e11793 = (bitcast<u32>(_e11788) << bitcast<u32>((_e11789 & 31i)));
let _e11800 = bitcast<u32>(((_e11788 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e11789) & 31i))));
let _e11804 = (bitcast<f32>((bitcast<u32>(_e11764) & 2147483647u)) >= 1073741800f);
let _e11807 = ((_e11764 * select(1f, _e11770, _e11804)) + 0.5f);
let _e11809 = select(-1073741800f, _e11807, (_e11807 > -1073741800f));
let _e11811 = select(1073741800f, _e11809, (_e11809 < 1073741800f));
let _e11818 = select(0i, select(select(i32(_e11811), i32(-2147483648), (_e11811 < -2147483600f)), 2147483647i, (_e11811 > 2147483500f)), (_e11811 == _e11811));
let _e11822 = (_e11818 - select(0i, 1i, (_e11811 < f32(_e11818))));
let _e11823 = select(0i, 20i, _e11804);
let _e11827 = (bitcast<u32>(_e11822) << bitcast<u32>((_e11823 & 31i)));
let _e11834 = bitcast<u32>(((_e11822 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e11823) & 31i))));
let _e11838 = (bitcast<f32>((bitcast<u32>(_e11765) & 2147483647u)) >= 1073741800f);
let _e11841 = ((_e11765 * select(1f, _e11770, _e11838)) + 0.5f);
let _e11843 = select(-1073741800f, _e11841, (_e11841 > -1073741800f));
let _e11845 = select(1073741800f, _e11843, (_e11843 < 1073741800f));
let _e11852 = select(0i, select(select(i32(_e11845), i32(-2147483648), (_e11845 < -2147483600f)), 2147483647i, (_e11845 > 2147483500f)), (_e11845 == _e11845));
let _e11856 = (_e11852 - select(0i, 1i, (_e11845 < f32(_e11852))));
let _e11857 = select(0i, 20i, _e11838);
let _e11861 = (bitcast<u32>(_e11856) << bitcast<u32>((_e11857 & 31i)));
let _e11868 = bitcast<u32>(((_e11856 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e11857) & 31i))));
let _e11873 = bitcast<i32>(bitcast<u32>((((_e11752.member_1 * _e966) + _e11752.member) * 6i)));
if ((_e11793 | _e11800) == 0u) {
} else {
let _e11876 = bitcast<u32>(_e11873);
if (_e11876 < _e304) {
let _e11880 = atomicAdd((&global_8.member[_e11876]), _e11793);
phi_56654_ = _e11880;
} else {
phi_56654_ = 0u;
}
let _e11882 = phi_56654_;
let _e11886 = (_e11800 + select(0u, 1u, ((_e11882 + _e11793) < _e11793)));
if (_e11886 == 0u) {
} else {
let _e11888 = (_e11876 + 1u);
if (_e11888 < _e304) {
let _e11892 = atomicAdd((&global_8.member[_e11888]), _e11886);
}
}
}
if ((_e11827 | _e11834) == 0u) {
} else {
let _e11896 = bitcast<u32>((_e11873 + 2i));
if (_e11896 < _e304) {
let _e11900 = atomicAdd((&global_8.member[_e11896]), _e11827);
phi_56684_ = _e11900;
} else {
phi_56684_ = 0u;
}
let _e11902 = phi_56684_;
let _e11906 = (_e11834 + select(0u, 1u, ((_e11902 + _e11827) < _e11827)));
if (_e11906 == 0u) {
} else {
let _e11908 = (_e11896 + 1u);
if (_e11908 < _e304) {
let _e11912 = atomicAdd((&global_8.member[_e11908]), _e11906);
}
}
}
if ((_e11861 | _e11868) == 0u) {
} else {
let _e11916 = bitcast<u32>((_e11873 + 4i));
if (_e11916 < _e304) {
let _e11920 = atomicAdd((&global_8.member[_e11916]), _e11861);
phi_56714_ = _e11920;
} else {
phi_56714_ = 0u;
}
let _e11922 = phi_56714_;
let _e11926 = (_e11868 + select(0u, 1u, ((_e11922 + _e11861) < _e11861)));
if (_e11926 == 0u) {
} else {
let _e11928 = (_e11916 + 1u);
if (_e11928 < _e304) {
let _e11932 = atomicAdd((&global_8.member[_e11928]), _e11926);
}
}
}
phi_55288_ = (_e11283 + 1i);
} else {
phi_55288_ = i32();
}
let _e11935 = phi_55288_;
continue;
continuing {
phi_55287_ = _e11935;
break if !(_e11286);
}
}
phi_55134_ = (_e11190 + 1i);
} else {
phi_55134_ = i32();
}
let _e11939 = phi_55134_;
continue;
continuing {
phi_55133_ = _e11939;
break if !(_e11191);
}
}
} else {
if (_e6959 == 1u) {
phi_56763_ = 0i;
loop {
let _e9746 = phi_56763_;
let _e9747 = (_e9746 < 16i);
if _e9747 {
let _e9749 = (_e1011 + (_e9746 & 15i));
let _e9751 = (f32(_e9749) + 0.5f);
let _e9753 = ((_e9751 * 1f) - 0.5f);
let _e9757 = (-(((_e450 * _e9753) + _e476)) / _e463);
let _e9764 = bitcast<f32>((bitcast<u32>(((_e500 * _e9753) + ((_e513 * _e9757) + _e526))) & 2147483647u));
let _e9771 = bitcast<f32>((bitcast<u32>(((_e539 * _e9753) + ((_e552 * _e9757) + _e565))) & 2147483647u));
let _e9775 = (((0.5f * (_e9764 + _e9771)) / _e568) + _e751);
let _e9776 = (1f / 1f);
let _e9784 = ((((_e9757 + _e9775) + 0.5f) * _e9776) - 0.5f);
let _e9785 = f32(_e1016);
let _e9786 = (0f - 1f);
let _e9788 = select(_e9786, _e9784, (_e9784 > _e9786));
let _e9790 = select(_e9785, _e9788, (_e9788 < _e9785));
let _e9797 = select(0i, select(select(i32(_e9790), i32(-2147483648), (_e9790 < -2147483600f)), 2147483647i, (_e9790 > 2147483500f)), (_e9790 == _e9790));
let _e9802 = (((((_e9757 - _e9775) + 0.5f) * _e9776) - 0.5f) + 1f);
let _e9803 = (_e9785 + 1f);
let _e9805 = select(0f, _e9802, (_e9802 > 0f));
let _e9807 = select(_e9803, _e9805, (_e9805 < _e9803));
let _e9814 = select(0i, select(select(i32(_e9807), i32(-2147483648), (_e9807 < -2147483600f)), 2147483647i, (_e9807 > 2147483500f)), (_e9807 == _e9807));
let _e9825 = ((1e-4f * 1f) * _e568);
let _e9827 = select(_e9771, _e9764, (_e9764 > _e9771));
let _e9829 = select(_e9825, _e9827, (_e9827 > _e9825));
let _e9831 = select(_e9771, _e9764, (_e9764 < _e9771));
let _e9833 = select(_e9825, _e9831, (_e9831 > _e9825));
let _e9835 = (0.5f * (_e9829 + _e9833));
let _e9836 = (0.5f / _e9833);
let _e9837 = (1f / _e9829);
phi_56917_ = 0i;
loop {
let _e9839 = phi_56917_;
let _e9841 = (((_e9814 - select(0i, 1i, (_e9807 < f32(_e9814)))) + (_e9746 >> bitcast<u32>(4u))) + bitcast<i32>(_e9839));
let _e9842 = (_e9841 <= select(-1i, (_e9797 - select(0i, 1i, (_e9790 < f32(_e9797)))), (_e9749 <= _e1015)));
if _e9842 {
let _e9844 = (f32(_e9841) + 0.5f);
let _e9848 = ((((_e9844 * 1f) - 0.5f) - _e9757) * _e568);
let _e9849 = (_e568 * 1f);
let _e9851 = (0.5f * _e9849);
let _e9852 = (_e9848 + _e9851);
let _e9853 = -(_e9852);
let _e9856 = (_e9835 - select(_e9853, _e9852, (_e9852 > _e9853)));
let _e9858 = select(0f, _e9856, (_e9856 > 0f));
let _e9860 = select(_e9833, _e9858, (_e9858 < _e9833));
let _e9863 = (_e9856 - _e9833);
let _e9867 = (((_e9860 * (_e9860 * _e9836)) + select(0f, _e9863, (_e9863 > 0f))) * _e9837);
let _e9871 = (_e9848 - _e9851);
let _e9872 = -(_e9871);
let _e9875 = (_e9835 - select(_e9872, _e9871, (_e9871 > _e9872)));
let _e9877 = select(0f, _e9875, (_e9875 > 0f));
let _e9879 = select(_e9833, _e9877, (_e9877 < _e9833));
let _e9882 = (_e9875 - _e9833);
let _e9886 = (((_e9879 * (_e9879 * _e9836)) + select(0f, _e9882, (_e9882 > 0f))) * _e9837);
if _e487 {
phi_57022_ = type_26(_e9841, _e9749);
} else {
phi_57022_ = type_26(_e9749, _e9841);
}
let _e9895 = phi_57022_;
local_76 = bitcast<i32>((_e962 * _e965));
local_77 = ((_e9895.member_1 * _e966) + _e9895.member);
let _e9902 = local_76;
let _e9903 = local_77;
let _e9904 = (_e9902 + _e9903);
let _e9906 = (bitcast<i32>(_e293) - 1i);
let _e9908 = select(_e9906, _e9904, (_e9904 < _e9906));
let _e9913 = global_5.member[bitcast<u32>(select(0i, _e9908, (_e9908 > 0i)))];
let _e9914 = local_77;
let _e9916 = select(_e9906, _e9914, (_e9914 < _e9906));
let _e9921 = global_5.member[bitcast<u32>(select(0i, _e9916, (_e9916 > 0i)))];
let _e9924 = f32(_e966);
let _e9925 = f32(_e967);
let _e9932 = global_1.member.member_2.member;
let _e9933 = (((((f32(_e9895.member) + 0.5f) / _e9924) * 2f) - 1f) * _e9932);
let _e9940 = global_1.member.member_2.member_1;
let _e9941 = ((1f - (((f32(_e9895.member_1) + 0.5f) / _e9925) * 2f)) * _e9940);
let _e9943 = global_1.member.member_3;
let _e9951 = global_1.member.member_4;
let _e9958 = ((_e9943.member * _e9933) + (_e9951.member * _e9941));
let _e9959 = ((_e9943.member_1 * _e9933) + (_e9951.member_1 * _e9941));
let _e9960 = ((_e9943.member_2 * _e9933) + (_e9951.member_2 * _e9941));
let _e9963 = global_1.member.member_2.member_3;
let _e9964 = (_e9963 != 0u);
let _e9966 = global_1.member.member_5;
let _e9973 = select((_e9966.member + _e9958), _e9966.member, _e9964);
let _e9974 = select((_e9966.member_1 + _e9959), _e9966.member_1, _e9964);
let _e9975 = select((_e9966.member_2 + _e9960), _e9966.member_2, _e9964);
let _e9977 = global_1.member.member_6;
let _e9991 = (((_e9973 * _e9973) + (_e9974 * _e9974)) + (_e9975 * _e9975));
let _e9994 = sqrt(select(0f, _e9991, (_e9991 > 0f)));
let _e9995 = (1f / _e9994);
let _e9996 = (_e9973 * _e9995);
let _e9997 = (_e9974 * _e9995);
let _e9998 = (_e9975 * _e9995);
let _e9999 = (_e609 - select(_e9977.member, (_e9977.member + _e9958), _e9964));
let _e10000 = (_e621 - select(_e9977.member_1, (_e9977.member_1 + _e9959), _e9964));
let _e10001 = (_e634 - select(_e9977.member_2, (_e9977.member_2 + _e9960), _e9964));
let _e10006 = (((_e9999 * _e9996) + (_e10000 * _e9997)) + (_e10001 * _e9998));
let _e10011 = (((_e9999 * _e647) + (_e10000 * _e660)) + (_e10001 * _e673));
let _e10016 = (((_e9996 * _e647) + (_e9997 * _e660)) + (_e9998 * _e673));
let _e10019 = ((_e9997 * _e673) - (_e9998 * _e660));
let _e10022 = ((_e9998 * _e647) - (_e9996 * _e673));
let _e10025 = ((_e9996 * _e660) - (_e9997 * _e647));
let _e10030 = (((_e10019 * _e10019) + (_e10022 * _e10022)) + (_e10025 * _e10025));
let _e10033 = (1f / select(1e-9f, _e10030, (_e10030 > 1e-9f)));
let _e10036 = ((_e10006 - (_e10016 * _e10011)) * _e10033);
let _e10039 = (((_e10016 * _e10006) - _e10011) * _e10033);
let _e10045 = -(_e10016);
let _e10048 = global_1.member.member_13.member_2;
let _e10049 = (_e10048 * _e10048);
let _e10053 = ((1f + _e10049) - ((2f * _e10048) * _e10045));
let _e10055 = select(1e-9f, _e10053, (_e10053 > 1e-9f));
let _e10067 = global_1.member.member_13.member_3;
if (_e10067 == 2u) {
let _e10072 = (0.5f - (0.5f * _e10045));
let _e10074 = select(0f, _e10072, (_e10072 > 0f));
let _e10078 = (sqrt(select(0f, _e10074, (_e10074 > 0f))) * 255f);
let _e10079 = (255f - 1f);
let _e10081 = select(0f, _e10078, (_e10078 > 0f));
let _e10083 = select(_e10079, _e10081, (_e10081 < _e10079));
let _e10090 = select(0i, select(select(i32(_e10083), i32(-2147483648), (_e10083 < -2147483600f)), 2147483647i, (_e10083 > 2147483500f)), (_e10083 == _e10083));
let _e10094 = (_e10090 - select(0i, 1i, (_e10083 < f32(_e10090))));
let _e10097 = global_1.member.member_13.member_11;
let _e10098 = bitcast<i32>(_e10097);
let _e10099 = (_e10098 + _e10094);
let _e10101 = (bitcast<i32>(_e299) - 1i);
let _e10103 = select(_e10101, _e10099, (_e10099 < _e10101));
let _e10108 = global_2.member[bitcast<u32>(select(0i, _e10103, (_e10103 > 0i)))];
let _e10110 = (_e10098 + (_e10094 + 1i));
let _e10112 = select(_e10101, _e10110, (_e10110 < _e10101));
let _e10117 = global_2.member[bitcast<u32>(select(0i, _e10112, (_e10112 > 0i)))];
phi_57449_ = (_e10108 + ((_e10117 - _e10108) * (_e10078 - f32(_e10094))));
} else {
phi_57449_ = select(((1f - _e10049) / (_e10055 * sqrt(select(0f, _e10055, (_e10055 > 0f))))), (0.75f * (1f + (_e10045 * _e10045))), (_e10067 == 1u));
}
let _e10124 = phi_57449_;
let _e10127 = (_e9994 * (_e10124 * (0.25f / 3.1415927f)));
let _e10128 = (_e10036 - _e9913);
let _e10131 = (_e10039 + select(0f, _e10128, (_e10128 > 0f)));
let _e10134 = global_1.member.member_13.member;
let _e10139 = -((_e10134.member * _e10131));
let _e10141 = select(-87f, _e10139, (_e10139 > -87f));
let _e10143 = select(88f, _e10141, (_e10141 < 88f));
let _e10145 = ((_e10143 * 1.442695f) + 0.5f);
let _e10147 = select(-127f, _e10145, (_e10145 > -127f));
let _e10149 = select(128f, _e10147, (_e10147 < 128f));
let _e10156 = select(0i, select(select(i32(_e10149), i32(-2147483648), (_e10149 < -2147483600f)), 2147483647i, (_e10149 > 2147483500f)), (_e10149 == _e10149));
let _e10160 = (_e10156 - select(0i, 1i, (_e10149 < f32(_e10156))));
let _e10161 = f32(_e10160);
let _e10165 = ((_e10143 - (_e10161 * 0.6933594f)) - (_e10161 * -2.1219444e-4f));
let _e10187 = -((_e10134.member_1 * _e10131));
let _e10189 = select(-87f, _e10187, (_e10187 > -87f));
let _e10191 = select(88f, _e10189, (_e10189 < 88f));
let _e10193 = ((_e10191 * 1.442695f) + 0.5f);
let _e10195 = select(-127f, _e10193, (_e10193 > -127f));
let _e10197 = select(128f, _e10195, (_e10195 < 128f));
let _e10204 = select(0i, select(select(i32(_e10197), i32(-2147483648), (_e10197 < -2147483600f)), 2147483647i, (_e10197 > 2147483500f)), (_e10197 == _e10197));
let _e10208 = (_e10204 - select(0i, 1i, (_e10197 < f32(_e10204))));
let _e10209 = f32(_e10208);
let _e10213 = ((_e10191 - (_e10209 * 0.6933594f)) - (_e10209 * -2.1219444e-4f));
let _e10235 = -((_e10134.member_2 * _e10131));
let _e10237 = select(-87f, _e10235, (_e10235 > -87f));
let _e10239 = select(88f, _e10237, (_e10237 < 88f));
let _e10241 = ((_e10239 * 1.442695f) + 0.5f);
let _e10243 = select(-127f, _e10241, (_e10241 > -127f));
let _e10245 = select(128f, _e10243, (_e10243 < 128f));
let _e10252 = select(0i, select(select(i32(_e10245), i32(-2147483648), (_e10245 < -2147483600f)), 2147483647i, (_e10245 > 2147483500f)), (_e10245 == _e10245));
let _e10256 = (_e10252 - select(0i, 1i, (_e10245 < f32(_e10252))));
let _e10257 = f32(_e10256);
let _e10261 = ((_e10239 - (_e10257 * 0.6933594f)) - (_e10257 * -2.1219444e-4f));
let _e10284 = global_1.member.member_13.member_1;
let _e10297 = select(0f, _e10036, (((_e10039 >= 0f) && (_e10039 < _e725)) && (_e10036 > 0f)));
let _e10299 = ((_e800 + _e6947) + _e6951);
let _e10300 = (_e10299 & 31u);
let _e10302 = (1u << bitcast<u32>(_e10300));
let _e10311 = bitcast<i32>((((_e962 + _e10302) - 1u) >> bitcast<u32>(_e10300)));
let _e10312 = bitcast<i32>((((_e965 + _e10302) - 1u) >> bitcast<u32>(_e10300)));
if _e487 {
phi_58077_ = type_26(_e10312, _e10311);
} else {
phi_58077_ = type_26(_e10311, _e10312);
}
let _e10316 = phi_58077_;
let _e10321 = f32((1i << bitcast<u32>(_e10300)));
let _e10322 = (1f / _e10321);
let _e10324 = ((_e9751 * _e10322) - 0.5f);
let _e10326 = ((_e9844 * _e10322) - 0.5f);
let _e10328 = select(-1f, _e10324, (_e10324 > -1f));
let _e10330 = select(1e6f, _e10328, (_e10328 < 1e6f));
let _e10337 = select(0i, select(select(i32(_e10330), i32(-2147483648), (_e10330 < -2147483600f)), 2147483647i, (_e10330 > 2147483500f)), (_e10330 == _e10330));
let _e10341 = (_e10337 - select(0i, 1i, (_e10330 < f32(_e10337))));
let _e10343 = select(-1f, _e10326, (_e10326 > -1f));
let _e10345 = select(1e6f, _e10343, (_e10343 < 1e6f));
let _e10352 = select(0i, select(select(i32(_e10345), i32(-2147483648), (_e10345 < -2147483600f)), 2147483647i, (_e10345 > 2147483500f)), (_e10345 == _e10345));
let _e10356 = (_e10352 - select(0i, 1i, (_e10345 < f32(_e10352))));
let _e10358 = (_e10324 - f32(_e10341));
let _e10360 = (_e10326 - f32(_e10356));
let _e10361 = (1f - _e10358);
let _e10362 = (1f - _e10360);
let _e10365 = select(_e10341, 0i, (_e10341 < 0i));
let _e10366 = (_e10365 >= _e10316.member);
if _e10366 {
phi_58155_ = (_e10316.member - 1i);
} else {
phi_58155_ = _e10365;
}
let _e10369 = phi_58155_;
let _e10371 = select(_e10356, 0i, (_e10356 < 0i));
let _e10372 = (_e10371 >= _e10316.member_1);
if _e10372 {
phi_58166_ = (_e10316.member_1 - 1i);
} else {
phi_58166_ = _e10371;
}
let _e10375 = phi_58166_;
let _e10379 = (((f32(_e10369) + 0.5f) * _e10321) - 0.5f);
let _e10383 = (((f32(_e10375) + 0.5f) * _e10321) - 0.5f);
if _e487 {
phi_58194_ = type_26(_e10375, _e10369);
} else {
phi_58194_ = type_26(_e10369, _e10375);
}
let _e10389 = phi_58194_;
let _e10395 = bitcast<i32>(((_e962 + 1u) >> bitcast<u32>(1u)));
let _e10398 = global_1.member.member_18.member_6;
let _e10401 = global_1.member.member_18.member_7;
let _e10404 = global_1.member.member_18.member_8;
let _e10405 = (_e10299 == 0u);
if _e10405 {
phi_58245_ = 0u;
} else {
if (_e10299 == 1u) {
phi_58244_ = 0u;
} else {
if (_e10299 == 2u) {
phi_58243_ = _e10398;
} else {
phi_58243_ = select(_e10404, _e10401, (_e10299 == 3u));
}
let _e10411 = phi_58243_;
phi_58244_ = _e10411;
}
let _e10413 = phi_58244_;
phi_58245_ = _e10413;
}
let _e10415 = phi_58245_;
local_74 = (((bitcast<i32>(_e10415) + _e10389.member_1) * _e10395) + _e10389.member);
let _e10420 = local_74;
let _e10422 = (bitcast<i32>(_e296) - 1i);
let _e10424 = select(_e10422, _e10420, (_e10420 < _e10422));
let _e10429 = global_6.member[bitcast<u32>(select(0i, _e10424, (_e10424 > 0i)))];
let _e10434 = (((((select(_e10379, _e10383, _e487) + 0.5f) / _e9924) * 2f) - 1f) * _e9932);
let _e10439 = ((1f - (((select(_e10383, _e10379, _e487) + 0.5f) / _e9925) * 2f)) * _e9940);
let _e10446 = ((_e9943.member * _e10434) + (_e9951.member * _e10439));
let _e10447 = ((_e9943.member_1 * _e10434) + (_e9951.member_1 * _e10439));
let _e10448 = ((_e9943.member_2 * _e10434) + (_e9951.member_2 * _e10439));
let _e10452 = select((_e9966.member + _e10446), _e9966.member, _e9964);
let _e10453 = select((_e9966.member_1 + _e10447), _e9966.member_1, _e9964);
let _e10454 = select((_e9966.member_2 + _e10448), _e9966.member_2, _e9964);
let _e10465 = (((_e10452 * _e10452) + (_e10453 * _e10453)) + (_e10454 * _e10454));
let _e10469 = (1f / sqrt(select(0f, _e10465, (_e10465 > 0f))));
let _e10470 = (_e10452 * _e10469);
let _e10471 = (_e10453 * _e10469);
let _e10472 = (_e10454 * _e10469);
let _e10473 = (_e609 - select(_e9977.member, (_e9977.member + _e10446), _e9964));
let _e10474 = (_e621 - select(_e9977.member_1, (_e9977.member_1 + _e10447), _e9964));
let _e10475 = (_e634 - select(_e9977.member_2, (_e9977.member_2 + _e10448), _e9964));
let _e10480 = (((_e10473 * _e10470) + (_e10474 * _e10471)) + (_e10475 * _e10472));
let _e10485 = (((_e10473 * _e647) + (_e10474 * _e660)) + (_e10475 * _e673));
let _e10490 = (((_e10470 * _e647) + (_e10471 * _e660)) + (_e10472 * _e673));
let _e10493 = ((_e10471 * _e673) - (_e10472 * _e660));
let _e10496 = ((_e10472 * _e647) - (_e10470 * _e673));
let _e10499 = ((_e10470 * _e660) - (_e10471 * _e647));
let _e10504 = (((_e10493 * _e10493) + (_e10496 * _e10496)) + (_e10499 * _e10499));
let _e10507 = (1f / select(1e-9f, _e10504, (_e10504 > 1e-9f)));
let _e10510 = ((_e10480 - (_e10490 * _e10485)) * _e10507);
let _e10513 = (((_e10490 * _e10480) - _e10485) * _e10507);
let _e10519 = select(0f, _e10510, (((_e10513 >= 0f) && (_e10513 < _e725)) && (_e10510 > 0f)));
let _e10521 = (_e10369 << bitcast<u32>(_e10300));
let _e10533 = (_e10341 + 1i);
let _e10536 = select(_e10533, 0i, (_e10533 < 0i));
let _e10537 = (_e10536 >= _e10316.member);
if _e10537 {
phi_59229_ = (_e10316.member - 1i);
} else {
phi_59229_ = _e10536;
}
let _e10540 = phi_59229_;
if _e10372 {
phi_59240_ = (_e10316.member_1 - 1i);
} else {
phi_59240_ = _e10371;
}
let _e10543 = phi_59240_;
let _e10547 = (((f32(_e10540) + 0.5f) * _e10321) - 0.5f);
let _e10551 = (((f32(_e10543) + 0.5f) * _e10321) - 0.5f);
if _e487 {
phi_59268_ = type_26(_e10543, _e10540);
} else {
phi_59268_ = type_26(_e10540, _e10543);
}
let _e10557 = phi_59268_;
if _e10405 {
phi_59319_ = 0u;
} else {
if (_e10299 == 1u) {
phi_59318_ = 0u;
} else {
if (_e10299 == 2u) {
phi_59317_ = _e10398;
} else {
phi_59317_ = select(_e10404, _e10401, (_e10299 == 3u));
}
let _e10565 = phi_59317_;
phi_59318_ = _e10565;
}
let _e10567 = phi_59318_;
phi_59319_ = _e10567;
}
let _e10569 = phi_59319_;
local_72 = (((bitcast<i32>(_e10569) + _e10557.member_1) * _e10395) + _e10557.member);
let _e10574 = local_72;
let _e10576 = select(_e10422, _e10574, (_e10574 < _e10422));
let _e10581 = global_6.member[bitcast<u32>(select(0i, _e10576, (_e10576 > 0i)))];
let _e10586 = (((((select(_e10547, _e10551, _e487) + 0.5f) / _e9924) * 2f) - 1f) * _e9932);
let _e10591 = ((1f - (((select(_e10551, _e10547, _e487) + 0.5f) / _e9925) * 2f)) * _e9940);
let _e10598 = ((_e9943.member * _e10586) + (_e9951.member * _e10591));
let _e10599 = ((_e9943.member_1 * _e10586) + (_e9951.member_1 * _e10591));
let _e10600 = ((_e9943.member_2 * _e10586) + (_e9951.member_2 * _e10591));
let _e10604 = select((_e9966.member + _e10598), _e9966.member, _e9964);
let _e10605 = select((_e9966.member_1 + _e10599), _e9966.member_1, _e9964);
let _e10606 = select((_e9966.member_2 + _e10600), _e9966.member_2, _e9964);
let _e10617 = (((_e10604 * _e10604) + (_e10605 * _e10605)) + (_e10606 * _e10606));
let _e10621 = (1f / sqrt(select(0f, _e10617, (_e10617 > 0f))));
let _e10622 = (_e10604 * _e10621);
let _e10623 = (_e10605 * _e10621);
let _e10624 = (_e10606 * _e10621);
let _e10625 = (_e609 - select(_e9977.member, (_e9977.member + _e10598), _e9964));
let _e10626 = (_e621 - select(_e9977.member_1, (_e9977.member_1 + _e10599), _e9964));
let _e10627 = (_e634 - select(_e9977.member_2, (_e9977.member_2 + _e10600), _e9964));
let _e10632 = (((_e10625 * _e10622) + (_e10626 * _e10623)) + (_e10627 * _e10624));
let _e10637 = (((_e10625 * _e647) + (_e10626 * _e660)) + (_e10627 * _e673));
let _e10642 = (((_e10622 * _e647) + (_e10623 * _e660)) + (_e10624 * _e673));
let _e10645 = ((_e10623 * _e673) - (_e10624 * _e660));
let _e10648 = ((_e10624 * _e647) - (_e10622 * _e673));
let _e10651 = ((_e10622 * _e660) - (_e10623 * _e647));
let _e10656 = (((_e10645 * _e10645) + (_e10648 * _e10648)) + (_e10651 * _e10651));
let _e10659 = (1f / select(1e-9f, _e10656, (_e10656 > 1e-9f)));
let _e10662 = ((_e10632 - (_e10642 * _e10637)) * _e10659);
let _e10665 = (((_e10642 * _e10632) - _e10637) * _e10659);
let _e10671 = select(0f, _e10662, (((_e10665 >= 0f) && (_e10665 < _e725)) && (_e10662 > 0f)));
let _e10673 = (_e10540 << bitcast<u32>(_e10300));
let _e10685 = (_e10356 + 1i);
if _e10366 {
phi_60303_ = (_e10316.member - 1i);
} else {
phi_60303_ = _e10365;
}
let _e10689 = phi_60303_;
let _e10691 = select(_e10685, 0i, (_e10685 < 0i));
let _e10692 = (_e10691 >= _e10316.member_1);
if _e10692 {
phi_60314_ = (_e10316.member_1 - 1i);
} else {
phi_60314_ = _e10691;
}
let _e10695 = phi_60314_;
let _e10699 = (((f32(_e10689) + 0.5f) * _e10321) - 0.5f);
let _e10703 = (((f32(_e10695) + 0.5f) * _e10321) - 0.5f);
if _e487 {
phi_60342_ = type_26(_e10695, _e10689);
} else {
phi_60342_ = type_26(_e10689, _e10695);
}
let _e10709 = phi_60342_;
if _e10405 {
phi_60393_ = 0u;
} else {
if (_e10299 == 1u) {
phi_60392_ = 0u;
} else {
if (_e10299 == 2u) {
phi_60391_ = _e10398;
} else {
phi_60391_ = select(_e10404, _e10401, (_e10299 == 3u));
}
let _e10717 = phi_60391_;
phi_60392_ = _e10717;
}
let _e10719 = phi_60392_;
phi_60393_ = _e10719;
}
let _e10721 = phi_60393_;
local_70 = (((bitcast<i32>(_e10721) + _e10709.member_1) * _e10395) + _e10709.member);
let _e10726 = local_70;
let _e10728 = select(_e10422, _e10726, (_e10726 < _e10422));
let _e10733 = global_6.member[bitcast<u32>(select(0i, _e10728, (_e10728 > 0i)))];
let _e10738 = (((((select(_e10699, _e10703, _e487) + 0.5f) / _e9924) * 2f) - 1f) * _e9932);
let _e10743 = ((1f - (((select(_e10703, _e10699, _e487) + 0.5f) / _e9925) * 2f)) * _e9940);
let _e10750 = ((_e9943.member * _e10738) + (_e9951.member * _e10743));
let _e10751 = ((_e9943.member_1 * _e10738) + (_e9951.member_1 * _e10743));
let _e10752 = ((_e9943.member_2 * _e10738) + (_e9951.member_2 * _e10743));
let _e10756 = select((_e9966.member + _e10750), _e9966.member, _e9964);
let _e10757 = select((_e9966.member_1 + _e10751), _e9966.member_1, _e9964);
let _e10758 = select((_e9966.member_2 + _e10752), _e9966.member_2, _e9964);
let _e10769 = (((_e10756 * _e10756) + (_e10757 * _e10757)) + (_e10758 * _e10758));
let _e10773 = (1f / sqrt(select(0f, _e10769, (_e10769 > 0f))));
let _e10774 = (_e10756 * _e10773);
let _e10775 = (_e10757 * _e10773);
let _e10776 = (_e10758 * _e10773);
let _e10777 = (_e609 - select(_e9977.member, (_e9977.member + _e10750), _e9964));
let _e10778 = (_e621 - select(_e9977.member_1, (_e9977.member_1 + _e10751), _e9964));
let _e10779 = (_e634 - select(_e9977.member_2, (_e9977.member_2 + _e10752), _e9964));
let _e10784 = (((_e10777 * _e10774) + (_e10778 * _e10775)) + (_e10779 * _e10776));
let _e10789 = (((_e10777 * _e647) + (_e10778 * _e660)) + (_e10779 * _e673));
let _e10794 = (((_e10774 * _e647) + (_e10775 * _e660)) + (_e10776 * _e673));
let _e10797 = ((_e10775 * _e673) - (_e10776 * _e660));
let _e10800 = ((_e10776 * _e647) - (_e10774 * _e673));
let _e10803 = ((_e10774 * _e660) - (_e10775 * _e647));
let _e10808 = (((_e10797 * _e10797) + (_e10800 * _e10800)) + (_e10803 * _e10803));
let _e10811 = (1f / select(1e-9f, _e10808, (_e10808 > 1e-9f)));
let _e10814 = ((_e10784 - (_e10794 * _e10789)) * _e10811);
let _e10817 = (((_e10794 * _e10784) - _e10789) * _e10811);
let _e10823 = select(0f, _e10814, (((_e10817 >= 0f) && (_e10817 < _e725)) && (_e10814 > 0f)));
let _e10825 = (_e10689 << bitcast<u32>(_e10300));
if _e10537 {
phi_61377_ = (_e10316.member - 1i);
} else {
phi_61377_ = _e10536;
}
let _e10840 = phi_61377_;
if _e10692 {
phi_61388_ = (_e10316.member_1 - 1i);
} else {
phi_61388_ = _e10691;
}
let _e10843 = phi_61388_;
let _e10847 = (((f32(_e10840) + 0.5f) * _e10321) - 0.5f);
let _e10851 = (((f32(_e10843) + 0.5f) * _e10321) - 0.5f);
if _e487 {
phi_61416_ = type_26(_e10843, _e10840);
} else {
phi_61416_ = type_26(_e10840, _e10843);
}
let _e10857 = phi_61416_;
if _e10405 {
phi_61467_ = 0u;
} else {
if (_e10299 == 1u) {
phi_61466_ = 0u;
} else {
if (_e10299 == 2u) {
phi_61465_ = _e10398;
} else {
phi_61465_ = select(_e10404, _e10401, (_e10299 == 3u));
}
let _e10865 = phi_61465_;
phi_61466_ = _e10865;
}
let _e10867 = phi_61466_;
phi_61467_ = _e10867;
}
let _e10869 = phi_61467_;
local_68 = (((bitcast<i32>(_e10869) + _e10857.member_1) * _e10395) + _e10857.member);
let _e10874 = local_68;
let _e10876 = select(_e10422, _e10874, (_e10874 < _e10422));
let _e10881 = global_6.member[bitcast<u32>(select(0i, _e10876, (_e10876 > 0i)))];
let _e10886 = (((((select(_e10847, _e10851, _e487) + 0.5f) / _e9924) * 2f) - 1f) * _e9932);
let _e10891 = ((1f - (((select(_e10851, _e10847, _e487) + 0.5f) / _e9925) * 2f)) * _e9940);
let _e10898 = ((_e9943.member * _e10886) + (_e9951.member * _e10891));
let _e10899 = ((_e9943.member_1 * _e10886) + (_e9951.member_1 * _e10891));
let _e10900 = ((_e9943.member_2 * _e10886) + (_e9951.member_2 * _e10891));
let _e10904 = select((_e9966.member + _e10898), _e9966.member, _e9964);
let _e10905 = select((_e9966.member_1 + _e10899), _e9966.member_1, _e9964);
let _e10906 = select((_e9966.member_2 + _e10900), _e9966.member_2, _e9964);
let _e10917 = (((_e10904 * _e10904) + (_e10905 * _e10905)) + (_e10906 * _e10906));
let _e10921 = (1f / sqrt(select(0f, _e10917, (_e10917 > 0f))));
let _e10922 = (_e10904 * _e10921);
let _e10923 = (_e10905 * _e10921);
let _e10924 = (_e10906 * _e10921);
let _e10925 = (_e609 - select(_e9977.member, (_e9977.member + _e10898), _e9964));
let _e10926 = (_e621 - select(_e9977.member_1, (_e9977.member_1 + _e10899), _e9964));
let _e10927 = (_e634 - select(_e9977.member_2, (_e9977.member_2 + _e10900), _e9964));
let _e10932 = (((_e10925 * _e10922) + (_e10926 * _e10923)) + (_e10927 * _e10924));
let _e10937 = (((_e10925 * _e647) + (_e10926 * _e660)) + (_e10927 * _e673));
let _e10942 = (((_e10922 * _e647) + (_e10923 * _e660)) + (_e10924 * _e673));
let _e10945 = ((_e10923 * _e673) - (_e10924 * _e660));
let _e10948 = ((_e10924 * _e647) - (_e10922 * _e673));
let _e10951 = ((_e10922 * _e660) - (_e10923 * _e647));
let _e10956 = (((_e10945 * _e10945) + (_e10948 * _e10948)) + (_e10951 * _e10951));
let _e10959 = (1f / select(1e-9f, _e10956, (_e10956 > 1e-9f)));
let _e10962 = ((_e10932 - (_e10942 * _e10937)) * _e10959);
let _e10965 = (((_e10942 * _e10932) - _e10937) * _e10959);
let _e10971 = select(0f, _e10962, (((_e10965 >= 0f) && (_e10965 < _e725)) && (_e10962 > 0f)));
let _e10973 = (_e10840 << bitcast<u32>(_e10300));
let _e10985 = select(((((1f - select(0f, (_e10361 * _e10362), (((select(select(_e800, _e957, (_e10521 >= _e726)), _e879, (_e10521 < _e332)) == _e10299) && (_e10519 > 0f)) && (_e10519 < _e10429)))) - select(0f, (_e10358 * _e10362), (((select(select(_e800, _e957, (_e10673 >= _e726)), _e879, (_e10673 < _e332)) == _e10299) && (_e10671 > 0f)) && (_e10671 < _e10581)))) - select(0f, (_e10361 * _e10360), (((select(select(_e800, _e957, (_e10825 >= _e726)), _e879, (_e10825 < _e332)) == _e10299) && (_e10823 > 0f)) && (_e10823 < _e10733)))) - select(0f, (_e10358 * _e10360), (((select(select(_e800, _e957, (_e10973 >= _e726)), _e879, (_e10973 < _e332)) == _e10299) && (_e10971 > 0f)) && (_e10971 < _e10881)))), 1f, _e10405);
if _e487 {
phi_62460_ = type_26(_e9841, _e9749);
} else {
phi_62460_ = type_26(_e9749, _e9841);
}
let _e11000 = phi_62460_;
let _e11003 = (_e9842 && (((_e10297 > 0f) && (_e10297 < _e9921)) && (bitcast<f32>((bitcast<u32>(_e10985) & 2147483647u)) > 1e-6f)));
let _e11006 = global_1.member.member_18.member;
let _e11007 = (((select(_e9867, (1f - _e9867), (_e9852 >= 0f)) - select(_e9886, (1f - _e9886), (_e9871 >= 0f))) * (1f / _e9849)) * _e11006);
let _e11011 = select(0f, (((((_e686 * _e10284.member) * ((1f + (_e10165 * (1f + (_e10165 * (0.5f + (_e10165 * (0.16666667f + (_e10165 * (0.041666668f + (_e10165 * (0.008333334f + (_e10165 * (0.001388889f + (_e10165 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e10160 + 127i)) << bitcast<u32>(23i))))) * _e10127) * _e10985) * _e11007), _e11003);
let _e11012 = select(0f, (((((_e699 * _e10284.member_1) * ((1f + (_e10213 * (1f + (_e10213 * (0.5f + (_e10213 * (0.16666667f + (_e10213 * (0.041666668f + (_e10213 * (0.008333334f + (_e10213 * (0.001388889f + (_e10213 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e10208 + 127i)) << bitcast<u32>(23i))))) * _e10127) * _e10985) * _e11007), _e11003);
let _e11013 = select(0f, (((((_e712 * _e10284.member_2) * ((1f + (_e10261 * (1f + (_e10261 * (0.5f + (_e10261 * (0.16666667f + (_e10261 * (0.041666668f + (_e10261 * (0.008333334f + (_e10261 * (0.001388889f + (_e10261 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e10256 + 127i)) << bitcast<u32>(23i))))) * _e10127) * _e10985) * _e11007), _e11003);
let _e11017 = (bitcast<f32>((bitcast<u32>(_e11011) & 2147483647u)) >= 1073741800f);
let _e11018 = (1f / 1048576f);
let _e11021 = ((_e11011 * select(1f, _e11018, _e11017)) + 0.5f);
let _e11023 = select(-1073741800f, _e11021, (_e11021 > -1073741800f));
let _e11025 = select(1073741800f, _e11023, (_e11023 < 1073741800f));
let _e11032 = select(0i, select(select(i32(_e11025), i32(-2147483648), (_e11025 < -2147483600f)), 2147483647i, (_e11025 > 2147483500f)), (_e11025 == _e11025));
let _e11036 = (_e11032 - select(0i, 1i, (_e11025 < f32(_e11032))));
let _e11037 = select(0i, 20i, _e11017);
let _e11041 = (bitcast<u32>(_e11036) << bitcast<u32>((_e11037 & 31i)));
let _e11048 = bitcast<u32>(((_e11036 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e11037) & 31i))));
let _e11052 = (bitcast<f32>((bitcast<u32>(_e11012) & 2147483647u)) >= 1073741800f);
let _e11055 = ((_e11012 * select(1f, _e11018, _e11052)) + 0.5f);
let _e11057 = select(-1073741800f, _e11055, (_e11055 > -1073741800f));
let _e11059 = select(1073741800f, _e11057, (_e11057 < 1073741800f));
let _e11066 = select(0i, select(select(i32(_e11059), i32(-2147483648), (_e11059 < -2147483600f)), 2147483647i, (_e11059 > 2147483500f)), (_e11059 == _e11059));
let _e11070 = (_e11066 - select(0i, 1i, (_e11059 < f32(_e11066))));
let _e11071 = select(0i, 20i, _e11052);
let _e11075 = (bitcast<u32>(_e11070) << bitcast<u32>((_e11071 & 31i)));
let _e11082 = bitcast<u32>(((_e11070 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e11071) & 31i))));
let _e11086 = (bitcast<f32>((bitcast<u32>(_e11013) & 2147483647u)) >= 1073741800f);
let _e11089 = ((_e11013 * select(1f, _e11018, _e11086)) + 0.5f);
let _e11091 = select(-1073741800f, _e11089, (_e11089 > -1073741800f));
let _e11093 = select(1073741800f, _e11091, (_e11091 < 1073741800f));
let _e11100 = select(0i, select(select(i32(_e11093), i32(-2147483648), (_e11093 < -2147483600f)), 2147483647i, (_e11093 > 2147483500f)), (_e11093 == _e11093));
let _e11104 = (_e11100 - select(0i, 1i, (_e11093 < f32(_e11100))));
let _e11105 = select(0i, 20i, _e11086);
let _e11109 = (bitcast<u32>(_e11104) << bitcast<u32>((_e11105 & 31i)));
let _e11116 = bitcast<u32>(((_e11104 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e11105) & 31i))));
let _e11121 = bitcast<i32>(bitcast<u32>((((_e11000.member_1 * _e966) + _e11000.member) * 6i)));
if ((_e11041 | _e11048) == 0u) {
} else {
let _e11124 = bitcast<u32>(_e11121);
if (_e11124 < _e304) {
let _e11128 = atomicAdd((&global_8.member[_e11124]), _e11041);
phi_62693_ = _e11128;
} else {
phi_62693_ = 0u;
}
let _e11130 = phi_62693_;
let _e11134 = (_e11048 + select(0u, 1u, ((_e11130 + _e11041) < _e11041)));
if (_e11134 == 0u) {
} else {
let _e11136 = (_e11124 + 1u);
if (_e11136 < _e304) {
let _e11140 = atomicAdd((&global_8.member[_e11136]), _e11134);
}
}
}
if ((_e11075 | _e11082) == 0u) {
} else {
let _e11144 = bitcast<u32>((_e11121 + 2i));
if (_e11144 < _e304) {
let _e11148 = atomicAdd((&global_8.member[_e11144]), _e11075);
phi_62723_ = _e11148;
} else {
phi_62723_ = 0u;
}
let _e11150 = phi_62723_;
let _e11154 = (_e11082 + select(0u, 1u, ((_e11150 + _e11075) < _e11075)));
if (_e11154 == 0u) {
} else {
let _e11156 = (_e11144 + 1u);
if (_e11156 < _e304) {
let _e11160 = atomicAdd((&global_8.member[_e11156]), _e11154);
}
}
}
if ((_e11109 | _e11116) == 0u) {
} else {
let _e11164 = bitcast<u32>((_e11121 + 4i));
if (_e11164 < _e304) {
let _e11168 = atomicAdd((&global_8.member[_e11164]), _e11109);
phi_62753_ = _e11168;
} else {
phi_62753_ = 0u;
}
let _e11170 = phi_62753_;
let _e11174 = (_e11116 + select(0u, 1u, ((_e11170 + _e11109) < _e11109)));
if (_e11174 == 0u) {
} else {
let _e11176 = (_e11164 + 1u);
if (_e11176 < _e304) {
let _e11180 = atomicAdd((&global_8.member[_e11176]), _e11174);
}
}
}
phi_56918_ = (_e9839 + 1i);
} else {
phi_56918_ = i32();
}
let _e11183 = phi_56918_;
continue;
continuing {
phi_56917_ = _e11183;
break if !(_e9842);
}
}
phi_56764_ = (_e9746 + 1i);
} else {
phi_56764_ = i32();
}
let _e11187 = phi_56764_;
continue;
continuing {
phi_56763_ = _e11187;
break if !(_e9747);
}
}
} else {
phi_62798_ = 0i;
loop {
let _e6963 = phi_62798_;
let _e6964 = (_e6963 < 16i);
if _e6964 {
let _e6966 = (_e1011 + (_e6963 & 15i));
let _e6968 = (f32(_e6966) + 0.5f);
let _e6970 = ((_e6968 * 1f) - 0.5f);
let _e6974 = (-(((_e450 * _e6970) + _e476)) / _e463);
let _e6981 = bitcast<f32>((bitcast<u32>(((_e500 * _e6970) + ((_e513 * _e6974) + _e526))) & 2147483647u));
let _e6988 = bitcast<f32>((bitcast<u32>(((_e539 * _e6970) + ((_e552 * _e6974) + _e565))) & 2147483647u));
let _e6992 = (((0.5f * (_e6981 + _e6988)) / _e568) + _e751);
let _e6993 = (1f / 1f);
let _e7001 = ((((_e6974 + _e6992) + 0.5f) * _e6993) - 0.5f);
let _e7002 = f32(_e1016);
let _e7003 = (0f - 1f);
let _e7005 = select(_e7003, _e7001, (_e7001 > _e7003));
let _e7007 = select(_e7002, _e7005, (_e7005 < _e7002));
let _e7014 = select(0i, select(select(i32(_e7007), i32(-2147483648), (_e7007 < -2147483600f)), 2147483647i, (_e7007 > 2147483500f)), (_e7007 == _e7007));
let _e7019 = (((((_e6974 - _e6992) + 0.5f) * _e6993) - 0.5f) + 1f);
let _e7020 = (_e7002 + 1f);
let _e7022 = select(0f, _e7019, (_e7019 > 0f));
let _e7024 = select(_e7020, _e7022, (_e7022 < _e7020));
let _e7031 = select(0i, select(select(i32(_e7024), i32(-2147483648), (_e7024 < -2147483600f)), 2147483647i, (_e7024 > 2147483500f)), (_e7024 == _e7024));
let _e7042 = ((1e-4f * 1f) * _e568);
let _e7044 = select(_e6988, _e6981, (_e6981 > _e6988));
let _e7046 = select(_e7042, _e7044, (_e7044 > _e7042));
let _e7048 = select(_e6988, _e6981, (_e6981 < _e6988));
let _e7050 = select(_e7042, _e7048, (_e7048 > _e7042));
let _e7052 = (0.5f * (_e7046 + _e7050));
let _e7053 = (0.5f / _e7050);
let _e7054 = (1f / _e7046);
phi_62952_ = 0i;
loop {
let _e7056 = phi_62952_;
let _e7058 = (((_e7031 - select(0i, 1i, (_e7024 < f32(_e7031)))) + (_e6963 >> bitcast<u32>(4u))) + bitcast<i32>(_e7056));
let _e7059 = (_e7058 <= select(-1i, (_e7014 - select(0i, 1i, (_e7007 < f32(_e7014)))), (_e6966 <= _e1015)));
if _e7059 {
let _e7061 = (f32(_e7058) + 0.5f);
let _e7065 = ((((_e7061 * 1f) - 0.5f) - _e6974) * _e568);
let _e7066 = (_e568 * 1f);
let _e7068 = (0.5f * _e7066);
let _e7069 = (_e7065 + _e7068);
let _e7070 = -(_e7069);
let _e7073 = (_e7052 - select(_e7070, _e7069, (_e7069 > _e7070)));
let _e7075 = select(0f, _e7073, (_e7073 > 0f));
let _e7077 = select(_e7050, _e7075, (_e7075 < _e7050));
let _e7080 = (_e7073 - _e7050);
let _e7084 = (((_e7077 * (_e7077 * _e7053)) + select(0f, _e7080, (_e7080 > 0f))) * _e7054);
let _e7088 = (_e7065 - _e7068);
let _e7089 = -(_e7088);
let _e7092 = (_e7052 - select(_e7089, _e7088, (_e7088 > _e7089)));
let _e7094 = select(0f, _e7092, (_e7092 > 0f));
let _e7096 = select(_e7050, _e7094, (_e7094 < _e7050));
let _e7099 = (_e7092 - _e7050);
let _e7103 = (((_e7096 * (_e7096 * _e7053)) + select(0f, _e7099, (_e7099 > 0f))) * _e7054);
if _e487 {
phi_63057_ = type_26(_e7058, _e6966);
} else {
phi_63057_ = type_26(_e6966, _e7058);
}
let _e7112 = phi_63057_;
local_66 = bitcast<i32>((_e962 * _e965));
local_67 = ((_e7112.member_1 * _e966) + _e7112.member);
let _e7119 = local_66;
let _e7120 = local_67;
let _e7121 = (_e7119 + _e7120);
let _e7123 = (bitcast<i32>(_e293) - 1i);
let _e7125 = select(_e7123, _e7121, (_e7121 < _e7123));
let _e7130 = global_5.member[bitcast<u32>(select(0i, _e7125, (_e7125 > 0i)))];
let _e7131 = local_67;
let _e7133 = select(_e7123, _e7131, (_e7131 < _e7123));
let _e7138 = global_5.member[bitcast<u32>(select(0i, _e7133, (_e7133 > 0i)))];
let _e7141 = f32(_e966);
let _e7142 = f32(_e967);
let _e7149 = global_1.member.member_2.member;
let _e7150 = (((((f32(_e7112.member) + 0.5f) / _e7141) * 2f) - 1f) * _e7149);
let _e7157 = global_1.member.member_2.member_1;
let _e7158 = ((1f - (((f32(_e7112.member_1) + 0.5f) / _e7142) * 2f)) * _e7157);
let _e7160 = global_1.member.member_3;
let _e7168 = global_1.member.member_4;
let _e7175 = ((_e7160.member * _e7150) + (_e7168.member * _e7158));
let _e7176 = ((_e7160.member_1 * _e7150) + (_e7168.member_1 * _e7158));
let _e7177 = ((_e7160.member_2 * _e7150) + (_e7168.member_2 * _e7158));
let _e7180 = global_1.member.member_2.member_3;
let _e7181 = (_e7180 != 0u);
let _e7183 = global_1.member.member_5;
let _e7190 = select((_e7183.member + _e7175), _e7183.member, _e7181);
let _e7191 = select((_e7183.member_1 + _e7176), _e7183.member_1, _e7181);
let _e7192 = select((_e7183.member_2 + _e7177), _e7183.member_2, _e7181);
let _e7194 = global_1.member.member_6;
let _e7208 = (((_e7190 * _e7190) + (_e7191 * _e7191)) + (_e7192 * _e7192));
let _e7211 = sqrt(select(0f, _e7208, (_e7208 > 0f)));
let _e7212 = (1f / _e7211);
let _e7213 = (_e7190 * _e7212);
let _e7214 = (_e7191 * _e7212);
let _e7215 = (_e7192 * _e7212);
let _e7216 = (_e609 - select(_e7194.member, (_e7194.member + _e7175), _e7181));
let _e7217 = (_e621 - select(_e7194.member_1, (_e7194.member_1 + _e7176), _e7181));
let _e7218 = (_e634 - select(_e7194.member_2, (_e7194.member_2 + _e7177), _e7181));
let _e7223 = (((_e7216 * _e7213) + (_e7217 * _e7214)) + (_e7218 * _e7215));
let _e7228 = (((_e7216 * _e647) + (_e7217 * _e660)) + (_e7218 * _e673));
let _e7233 = (((_e7213 * _e647) + (_e7214 * _e660)) + (_e7215 * _e673));
let _e7236 = ((_e7214 * _e673) - (_e7215 * _e660));
let _e7239 = ((_e7215 * _e647) - (_e7213 * _e673));
let _e7242 = ((_e7213 * _e660) - (_e7214 * _e647));
let _e7247 = (((_e7236 * _e7236) + (_e7239 * _e7239)) + (_e7242 * _e7242));
let _e7250 = (1f / select(1e-9f, _e7247, (_e7247 > 1e-9f)));
let _e7253 = ((_e7223 - (_e7233 * _e7228)) * _e7250);
let _e7256 = (((_e7233 * _e7223) - _e7228) * _e7250);
let _e7262 = -(_e7233);
let _e7265 = global_1.member.member_13.member_2;
let _e7266 = (_e7265 * _e7265);
let _e7270 = ((1f + _e7266) - ((2f * _e7265) * _e7262));
let _e7272 = select(1e-9f, _e7270, (_e7270 > 1e-9f));
let _e7284 = global_1.member.member_13.member_3;
if (_e7284 == 2u) {
let _e7289 = (0.5f - (0.5f * _e7262));
let _e7291 = select(0f, _e7289, (_e7289 > 0f));
let _e7295 = (sqrt(select(0f, _e7291, (_e7291 > 0f))) * 255f);
let _e7296 = (255f - 1f);
let _e7298 = select(0f, _e7295, (_e7295 > 0f));
let _e7300 = select(_e7296, _e7298, (_e7298 < _e7296));
let _e7307 = select(0i, select(select(i32(_e7300), i32(-2147483648), (_e7300 < -2147483600f)), 2147483647i, (_e7300 > 2147483500f)), (_e7300 == _e7300));
let _e7311 = (_e7307 - select(0i, 1i, (_e7300 < f32(_e7307))));
let _e7314 = global_1.member.member_13.member_11;
let _e7315 = bitcast<i32>(_e7314);
let _e7316 = (_e7315 + _e7311);
let _e7318 = (bitcast<i32>(_e299) - 1i);
let _e7320 = select(_e7318, _e7316, (_e7316 < _e7318));
let _e7325 = global_2.member[bitcast<u32>(select(0i, _e7320, (_e7320 > 0i)))];
let _e7327 = (_e7315 + (_e7311 + 1i));
let _e7329 = select(_e7318, _e7327, (_e7327 < _e7318));
let _e7334 = global_2.member[bitcast<u32>(select(0i, _e7329, (_e7329 > 0i)))];
phi_63484_ = (_e7325 + ((_e7334 - _e7325) * (_e7295 - f32(_e7311))));
} else {
phi_63484_ = select(((1f - _e7266) / (_e7272 * sqrt(select(0f, _e7272, (_e7272 > 0f))))), (0.75f * (1f + (_e7262 * _e7262))), (_e7284 == 1u));
}
let _e7341 = phi_63484_;
let _e7344 = (_e7211 * (_e7341 * (0.25f / 3.1415927f)));
let _e7345 = (_e7253 - _e7130);
let _e7348 = (_e7256 + select(0f, _e7345, (_e7345 > 0f)));
let _e7351 = global_1.member.member_13.member;
let _e7356 = -((_e7351.member * _e7348));
let _e7358 = select(-87f, _e7356, (_e7356 > -87f));
let _e7360 = select(88f, _e7358, (_e7358 < 88f));
let _e7362 = ((_e7360 * 1.442695f) + 0.5f);
let _e7364 = select(-127f, _e7362, (_e7362 > -127f));
let _e7366 = select(128f, _e7364, (_e7364 < 128f));
let _e7373 = select(0i, select(select(i32(_e7366), i32(-2147483648), (_e7366 < -2147483600f)), 2147483647i, (_e7366 > 2147483500f)), (_e7366 == _e7366));
let _e7377 = (_e7373 - select(0i, 1i, (_e7366 < f32(_e7373))));
let _e7378 = f32(_e7377);
let _e7382 = ((_e7360 - (_e7378 * 0.6933594f)) - (_e7378 * -2.1219444e-4f));
let _e7404 = -((_e7351.member_1 * _e7348));
let _e7406 = select(-87f, _e7404, (_e7404 > -87f));
let _e7408 = select(88f, _e7406, (_e7406 < 88f));
let _e7410 = ((_e7408 * 1.442695f) + 0.5f);
let _e7412 = select(-127f, _e7410, (_e7410 > -127f));
let _e7414 = select(128f, _e7412, (_e7412 < 128f));
let _e7421 = select(0i, select(select(i32(_e7414), i32(-2147483648), (_e7414 < -2147483600f)), 2147483647i, (_e7414 > 2147483500f)), (_e7414 == _e7414));
let _e7425 = (_e7421 - select(0i, 1i, (_e7414 < f32(_e7421))));
let _e7426 = f32(_e7425);
let _e7430 = ((_e7408 - (_e7426 * 0.6933594f)) - (_e7426 * -2.1219444e-4f));
let _e7452 = -((_e7351.member_2 * _e7348));
let _e7454 = select(-87f, _e7452, (_e7452 > -87f));
let _e7456 = select(88f, _e7454, (_e7454 < 88f));
let _e7458 = ((_e7456 * 1.442695f) + 0.5f);
let _e7460 = select(-127f, _e7458, (_e7458 > -127f));
let _e7462 = select(128f, _e7460, (_e7460 < 128f));
let _e7469 = select(0i, select(select(i32(_e7462), i32(-2147483648), (_e7462 < -2147483600f)), 2147483647i, (_e7462 > 2147483500f)), (_e7462 == _e7462));
let _e7473 = (_e7469 - select(0i, 1i, (_e7462 < f32(_e7469))));
let _e7474 = f32(_e7473);
let _e7478 = ((_e7456 - (_e7474 * 0.6933594f)) - (_e7474 * -2.1219444e-4f));
let _e7501 = global_1.member.member_13.member_1;
let _e7514 = select(0f, _e7253, (((_e7256 >= 0f) && (_e7256 < _e725)) && (_e7253 > 0f)));
let _e7515 = (_e800 & 31u);
let _e7517 = (1u << bitcast<u32>(_e7515));
let _e7526 = bitcast<i32>((((_e962 + _e7517) - 1u) >> bitcast<u32>(_e7515)));
let _e7527 = bitcast<i32>((((_e965 + _e7517) - 1u) >> bitcast<u32>(_e7515)));
if _e487 {
phi_64110_ = type_26(_e7527, _e7526);
} else {
phi_64110_ = type_26(_e7526, _e7527);
}
let _e7531 = phi_64110_;
let _e7536 = f32((1i << bitcast<u32>(_e7515)));
let _e7537 = (1f / _e7536);
let _e7539 = ((_e6968 * _e7537) - 0.5f);
let _e7541 = ((_e7061 * _e7537) - 0.5f);
let _e7543 = select(-1f, _e7539, (_e7539 > -1f));
let _e7545 = select(1e6f, _e7543, (_e7543 < 1e6f));
let _e7552 = select(0i, select(select(i32(_e7545), i32(-2147483648), (_e7545 < -2147483600f)), 2147483647i, (_e7545 > 2147483500f)), (_e7545 == _e7545));
let _e7556 = (_e7552 - select(0i, 1i, (_e7545 < f32(_e7552))));
let _e7558 = select(-1f, _e7541, (_e7541 > -1f));
let _e7560 = select(1e6f, _e7558, (_e7558 < 1e6f));
let _e7567 = select(0i, select(select(i32(_e7560), i32(-2147483648), (_e7560 < -2147483600f)), 2147483647i, (_e7560 > 2147483500f)), (_e7560 == _e7560));
let _e7571 = (_e7567 - select(0i, 1i, (_e7560 < f32(_e7567))));
let _e7573 = (_e7539 - f32(_e7556));
let _e7575 = (_e7541 - f32(_e7571));
let _e7576 = (1f - _e7573);
let _e7577 = (1f - _e7575);
let _e7580 = select(_e7556, 0i, (_e7556 < 0i));
let _e7581 = (_e7580 >= _e7531.member);
if _e7581 {
phi_64188_ = (_e7531.member - 1i);
} else {
phi_64188_ = _e7580;
}
let _e7584 = phi_64188_;
let _e7586 = select(_e7571, 0i, (_e7571 < 0i));
let _e7587 = (_e7586 >= _e7531.member_1);
if _e7587 {
phi_64199_ = (_e7531.member_1 - 1i);
} else {
phi_64199_ = _e7586;
}
let _e7590 = phi_64199_;
let _e7594 = (((f32(_e7584) + 0.5f) * _e7536) - 0.5f);
let _e7598 = (((f32(_e7590) + 0.5f) * _e7536) - 0.5f);
if _e487 {
phi_64227_ = type_26(_e7590, _e7584);
} else {
phi_64227_ = type_26(_e7584, _e7590);
}
let _e7604 = phi_64227_;
let _e7610 = bitcast<i32>(((_e962 + 1u) >> bitcast<u32>(1u)));
let _e7613 = global_1.member.member_18.member_6;
let _e7616 = global_1.member.member_18.member_7;
let _e7619 = global_1.member.member_18.member_8;
if _e1017 {
phi_64278_ = 0u;
} else {
if (_e800 == 1u) {
phi_64277_ = 0u;
} else {
if (_e800 == 2u) {
phi_64276_ = _e7613;
} else {
phi_64276_ = select(_e7619, _e7616, (_e800 == 3u));
}
let _e7625 = phi_64276_;
phi_64277_ = _e7625;
}
let _e7627 = phi_64277_;
phi_64278_ = _e7627;
}
let _e7629 = phi_64278_;
local_64 = (((bitcast<i32>(_e7629) + _e7604.member_1) * _e7610) + _e7604.member);
let _e7634 = local_64;
let _e7636 = (bitcast<i32>(_e296) - 1i);
let _e7638 = select(_e7636, _e7634, (_e7634 < _e7636));
let _e7643 = global_6.member[bitcast<u32>(select(0i, _e7638, (_e7638 > 0i)))];
let _e7648 = (((((select(_e7594, _e7598, _e487) + 0.5f) / _e7141) * 2f) - 1f) * _e7149);
let _e7653 = ((1f - (((select(_e7598, _e7594, _e487) + 0.5f) / _e7142) * 2f)) * _e7157);
let _e7660 = ((_e7160.member * _e7648) + (_e7168.member * _e7653));
let _e7661 = ((_e7160.member_1 * _e7648) + (_e7168.member_1 * _e7653));
let _e7662 = ((_e7160.member_2 * _e7648) + (_e7168.member_2 * _e7653));
let _e7666 = select((_e7183.member + _e7660), _e7183.member, _e7181);
let _e7667 = select((_e7183.member_1 + _e7661), _e7183.member_1, _e7181);
let _e7668 = select((_e7183.member_2 + _e7662), _e7183.member_2, _e7181);
let _e7679 = (((_e7666 * _e7666) + (_e7667 * _e7667)) + (_e7668 * _e7668));
let _e7683 = (1f / sqrt(select(0f, _e7679, (_e7679 > 0f))));
let _e7684 = (_e7666 * _e7683);
let _e7685 = (_e7667 * _e7683);
let _e7686 = (_e7668 * _e7683);
let _e7687 = (_e609 - select(_e7194.member, (_e7194.member + _e7660), _e7181));
let _e7688 = (_e621 - select(_e7194.member_1, (_e7194.member_1 + _e7661), _e7181));
let _e7689 = (_e634 - select(_e7194.member_2, (_e7194.member_2 + _e7662), _e7181));
let _e7694 = (((_e7687 * _e7684) + (_e7688 * _e7685)) + (_e7689 * _e7686));
let _e7699 = (((_e7687 * _e647) + (_e7688 * _e660)) + (_e7689 * _e673));
let _e7704 = (((_e7684 * _e647) + (_e7685 * _e660)) + (_e7686 * _e673));
let _e7707 = ((_e7685 * _e673) - (_e7686 * _e660));
let _e7710 = ((_e7686 * _e647) - (_e7684 * _e673));
let _e7713 = ((_e7684 * _e660) - (_e7685 * _e647));
let _e7718 = (((_e7707 * _e7707) + (_e7710 * _e7710)) + (_e7713 * _e7713));
let _e7721 = (1f / select(1e-9f, _e7718, (_e7718 > 1e-9f)));
let _e7724 = ((_e7694 - (_e7704 * _e7699)) * _e7721);
let _e7727 = (((_e7704 * _e7694) - _e7699) * _e7721);
let _e7733 = select(0f, _e7724, (((_e7727 >= 0f) && (_e7727 < _e725)) && (_e7724 > 0f)));
let _e7735 = (_e7584 << bitcast<u32>(_e7515));
let _e7747 = (_e7556 + 1i);
let _e7750 = select(_e7747, 0i, (_e7747 < 0i));
let _e7751 = (_e7750 >= _e7531.member);
if _e7751 {
phi_65262_ = (_e7531.member - 1i);
} else {
phi_65262_ = _e7750;
}
let _e7754 = phi_65262_;
if _e7587 {
phi_65273_ = (_e7531.member_1 - 1i);
} else {
phi_65273_ = _e7586;
}
let _e7757 = phi_65273_;
let _e7761 = (((f32(_e7754) + 0.5f) * _e7536) - 0.5f);
let _e7765 = (((f32(_e7757) + 0.5f) * _e7536) - 0.5f);
if _e487 {
phi_65301_ = type_26(_e7757, _e7754);
} else {
phi_65301_ = type_26(_e7754, _e7757);
}
let _e7771 = phi_65301_;
if _e1017 {
phi_65352_ = 0u;
} else {
if (_e800 == 1u) {
phi_65351_ = 0u;
} else {
if (_e800 == 2u) {
phi_65350_ = _e7613;
} else {
phi_65350_ = select(_e7619, _e7616, (_e800 == 3u));
}
let _e7779 = phi_65350_;
phi_65351_ = _e7779;
}
let _e7781 = phi_65351_;
phi_65352_ = _e7781;
}
let _e7783 = phi_65352_;
local_62 = (((bitcast<i32>(_e7783) + _e7771.member_1) * _e7610) + _e7771.member);
let _e7788 = local_62;
let _e7790 = select(_e7636, _e7788, (_e7788 < _e7636));
let _e7795 = global_6.member[bitcast<u32>(select(0i, _e7790, (_e7790 > 0i)))];
let _e7800 = (((((select(_e7761, _e7765, _e487) + 0.5f) / _e7141) * 2f) - 1f) * _e7149);
let _e7805 = ((1f - (((select(_e7765, _e7761, _e487) + 0.5f) / _e7142) * 2f)) * _e7157);
let _e7812 = ((_e7160.member * _e7800) + (_e7168.member * _e7805));
let _e7813 = ((_e7160.member_1 * _e7800) + (_e7168.member_1 * _e7805));
let _e7814 = ((_e7160.member_2 * _e7800) + (_e7168.member_2 * _e7805));
let _e7818 = select((_e7183.member + _e7812), _e7183.member, _e7181);
let _e7819 = select((_e7183.member_1 + _e7813), _e7183.member_1, _e7181);
let _e7820 = select((_e7183.member_2 + _e7814), _e7183.member_2, _e7181);
let _e7831 = (((_e7818 * _e7818) + (_e7819 * _e7819)) + (_e7820 * _e7820));
let _e7835 = (1f / sqrt(select(0f, _e7831, (_e7831 > 0f))));
let _e7836 = (_e7818 * _e7835);
let _e7837 = (_e7819 * _e7835);
let _e7838 = (_e7820 * _e7835);
let _e7839 = (_e609 - select(_e7194.member, (_e7194.member + _e7812), _e7181));
let _e7840 = (_e621 - select(_e7194.member_1, (_e7194.member_1 + _e7813), _e7181));
let _e7841 = (_e634 - select(_e7194.member_2, (_e7194.member_2 + _e7814), _e7181));
let _e7846 = (((_e7839 * _e7836) + (_e7840 * _e7837)) + (_e7841 * _e7838));
let _e7851 = (((_e7839 * _e647) + (_e7840 * _e660)) + (_e7841 * _e673));
let _e7856 = (((_e7836 * _e647) + (_e7837 * _e660)) + (_e7838 * _e673));
let _e7859 = ((_e7837 * _e673) - (_e7838 * _e660));
let _e7862 = ((_e7838 * _e647) - (_e7836 * _e673));
let _e7865 = ((_e7836 * _e660) - (_e7837 * _e647));
let _e7870 = (((_e7859 * _e7859) + (_e7862 * _e7862)) + (_e7865 * _e7865));
let _e7873 = (1f / select(1e-9f, _e7870, (_e7870 > 1e-9f)));
let _e7876 = ((_e7846 - (_e7856 * _e7851)) * _e7873);
let _e7879 = (((_e7856 * _e7846) - _e7851) * _e7873);
let _e7885 = select(0f, _e7876, (((_e7879 >= 0f) && (_e7879 < _e725)) && (_e7876 > 0f)));
let _e7887 = (_e7754 << bitcast<u32>(_e7515));
let _e7899 = (_e7571 + 1i);
if _e7581 {
phi_66336_ = (_e7531.member - 1i);
} else {
phi_66336_ = _e7580;
}
let _e7903 = phi_66336_;
let _e7905 = select(_e7899, 0i, (_e7899 < 0i));
let _e7906 = (_e7905 >= _e7531.member_1);
if _e7906 {
phi_66347_ = (_e7531.member_1 - 1i);
} else {
phi_66347_ = _e7905;
}
let _e7909 = phi_66347_;
let _e7913 = (((f32(_e7903) + 0.5f) * _e7536) - 0.5f);
let _e7917 = (((f32(_e7909) + 0.5f) * _e7536) - 0.5f);
if _e487 {
phi_66375_ = type_26(_e7909, _e7903);
} else {
phi_66375_ = type_26(_e7903, _e7909);
}
let _e7923 = phi_66375_;
if _e1017 {
phi_66426_ = 0u;
} else {
if (_e800 == 1u) {
phi_66425_ = 0u;
} else {
if (_e800 == 2u) {
phi_66424_ = _e7613;
} else {
phi_66424_ = select(_e7619, _e7616, (_e800 == 3u));
}
let _e7931 = phi_66424_;
phi_66425_ = _e7931;
}
let _e7933 = phi_66425_;
phi_66426_ = _e7933;
}
let _e7935 = phi_66426_;
local_60 = (((bitcast<i32>(_e7935) + _e7923.member_1) * _e7610) + _e7923.member);
let _e7940 = local_60;
let _e7942 = select(_e7636, _e7940, (_e7940 < _e7636));
let _e7947 = global_6.member[bitcast<u32>(select(0i, _e7942, (_e7942 > 0i)))];
let _e7952 = (((((select(_e7913, _e7917, _e487) + 0.5f) / _e7141) * 2f) - 1f) * _e7149);
let _e7957 = ((1f - (((select(_e7917, _e7913, _e487) + 0.5f) / _e7142) * 2f)) * _e7157);
let _e7964 = ((_e7160.member * _e7952) + (_e7168.member * _e7957));
let _e7965 = ((_e7160.member_1 * _e7952) + (_e7168.member_1 * _e7957));
let _e7966 = ((_e7160.member_2 * _e7952) + (_e7168.member_2 * _e7957));
let _e7970 = select((_e7183.member + _e7964), _e7183.member, _e7181);
let _e7971 = select((_e7183.member_1 + _e7965), _e7183.member_1, _e7181);
let _e7972 = select((_e7183.member_2 + _e7966), _e7183.member_2, _e7181);
let _e7983 = (((_e7970 * _e7970) + (_e7971 * _e7971)) + (_e7972 * _e7972));
let _e7987 = (1f / sqrt(select(0f, _e7983, (_e7983 > 0f))));
let _e7988 = (_e7970 * _e7987);
let _e7989 = (_e7971 * _e7987);
let _e7990 = (_e7972 * _e7987);
let _e7991 = (_e609 - select(_e7194.member, (_e7194.member + _e7964), _e7181));
let _e7992 = (_e621 - select(_e7194.member_1, (_e7194.member_1 + _e7965), _e7181));
let _e7993 = (_e634 - select(_e7194.member_2, (_e7194.member_2 + _e7966), _e7181));
let _e7998 = (((_e7991 * _e7988) + (_e7992 * _e7989)) + (_e7993 * _e7990));
let _e8003 = (((_e7991 * _e647) + (_e7992 * _e660)) + (_e7993 * _e673));
let _e8008 = (((_e7988 * _e647) + (_e7989 * _e660)) + (_e7990 * _e673));
let _e8011 = ((_e7989 * _e673) - (_e7990 * _e660));
let _e8014 = ((_e7990 * _e647) - (_e7988 * _e673));
let _e8017 = ((_e7988 * _e660) - (_e7989 * _e647));
let _e8022 = (((_e8011 * _e8011) + (_e8014 * _e8014)) + (_e8017 * _e8017));
let _e8025 = (1f / select(1e-9f, _e8022, (_e8022 > 1e-9f)));
let _e8028 = ((_e7998 - (_e8008 * _e8003)) * _e8025);
let _e8031 = (((_e8008 * _e7998) - _e8003) * _e8025);
let _e8037 = select(0f, _e8028, (((_e8031 >= 0f) && (_e8031 < _e725)) && (_e8028 > 0f)));
let _e8039 = (_e7903 << bitcast<u32>(_e7515));
if _e7751 {
phi_67410_ = (_e7531.member - 1i);
} else {
phi_67410_ = _e7750;
}
let _e8054 = phi_67410_;
if _e7906 {
phi_67421_ = (_e7531.member_1 - 1i);
} else {
phi_67421_ = _e7905;
}
let _e8057 = phi_67421_;
let _e8061 = (((f32(_e8054) + 0.5f) * _e7536) - 0.5f);
let _e8065 = (((f32(_e8057) + 0.5f) * _e7536) - 0.5f);
if _e487 {
phi_67449_ = type_26(_e8057, _e8054);
} else {
phi_67449_ = type_26(_e8054, _e8057);
}
let _e8071 = phi_67449_;
if _e1017 {
phi_67500_ = 0u;
} else {
if (_e800 == 1u) {
phi_67499_ = 0u;
} else {
if (_e800 == 2u) {
phi_67498_ = _e7613;
} else {
phi_67498_ = select(_e7619, _e7616, (_e800 == 3u));
}
let _e8079 = phi_67498_;
phi_67499_ = _e8079;
}
let _e8081 = phi_67499_;
phi_67500_ = _e8081;
}
let _e8083 = phi_67500_;
local_58 = (((bitcast<i32>(_e8083) + _e8071.member_1) * _e7610) + _e8071.member);
let _e8088 = local_58;
let _e8090 = select(_e7636, _e8088, (_e8088 < _e7636));
let _e8095 = global_6.member[bitcast<u32>(select(0i, _e8090, (_e8090 > 0i)))];
let _e8100 = (((((select(_e8061, _e8065, _e487) + 0.5f) / _e7141) * 2f) - 1f) * _e7149);
let _e8105 = ((1f - (((select(_e8065, _e8061, _e487) + 0.5f) / _e7142) * 2f)) * _e7157);
let _e8112 = ((_e7160.member * _e8100) + (_e7168.member * _e8105));
let _e8113 = ((_e7160.member_1 * _e8100) + (_e7168.member_1 * _e8105));
let _e8114 = ((_e7160.member_2 * _e8100) + (_e7168.member_2 * _e8105));
let _e8118 = select((_e7183.member + _e8112), _e7183.member, _e7181);
let _e8119 = select((_e7183.member_1 + _e8113), _e7183.member_1, _e7181);
let _e8120 = select((_e7183.member_2 + _e8114), _e7183.member_2, _e7181);
let _e8131 = (((_e8118 * _e8118) + (_e8119 * _e8119)) + (_e8120 * _e8120));
let _e8135 = (1f / sqrt(select(0f, _e8131, (_e8131 > 0f))));
let _e8136 = (_e8118 * _e8135);
let _e8137 = (_e8119 * _e8135);
let _e8138 = (_e8120 * _e8135);
let _e8139 = (_e609 - select(_e7194.member, (_e7194.member + _e8112), _e7181));
let _e8140 = (_e621 - select(_e7194.member_1, (_e7194.member_1 + _e8113), _e7181));
let _e8141 = (_e634 - select(_e7194.member_2, (_e7194.member_2 + _e8114), _e7181));
let _e8146 = (((_e8139 * _e8136) + (_e8140 * _e8137)) + (_e8141 * _e8138));
let _e8151 = (((_e8139 * _e647) + (_e8140 * _e660)) + (_e8141 * _e673));
let _e8156 = (((_e8136 * _e647) + (_e8137 * _e660)) + (_e8138 * _e673));
let _e8159 = ((_e8137 * _e673) - (_e8138 * _e660));
let _e8162 = ((_e8138 * _e647) - (_e8136 * _e673));
let _e8165 = ((_e8136 * _e660) - (_e8137 * _e647));
let _e8170 = (((_e8159 * _e8159) + (_e8162 * _e8162)) + (_e8165 * _e8165));
let _e8173 = (1f / select(1e-9f, _e8170, (_e8170 > 1e-9f)));
let _e8176 = ((_e8146 - (_e8156 * _e8151)) * _e8173);
let _e8179 = (((_e8156 * _e8146) - _e8151) * _e8173);
let _e8185 = select(0f, _e8176, (((_e8179 >= 0f) && (_e8179 < _e725)) && (_e8176 > 0f)));
let _e8187 = (_e8054 << bitcast<u32>(_e7515));
let _e8199 = select(((((1f - select(0f, (_e7576 * _e7577), (((select(select(_e800, _e957, (_e7735 >= _e726)), _e879, (_e7735 < _e332)) == _e800) && (_e7733 > 0f)) && (_e7733 < _e7643)))) - select(0f, (_e7573 * _e7577), (((select(select(_e800, _e957, (_e7887 >= _e726)), _e879, (_e7887 < _e332)) == _e800) && (_e7885 > 0f)) && (_e7885 < _e7795)))) - select(0f, (_e7576 * _e7575), (((select(select(_e800, _e957, (_e8039 >= _e726)), _e879, (_e8039 < _e332)) == _e800) && (_e8037 > 0f)) && (_e8037 < _e7947)))) - select(0f, (_e7573 * _e7575), (((select(select(_e800, _e957, (_e8187 >= _e726)), _e879, (_e8187 < _e332)) == _e800) && (_e8185 > 0f)) && (_e8185 < _e8095)))), 1f, _e1017);
let _e8200 = (_e6947 & 31u);
let _e8202 = (1u << bitcast<u32>(_e8200));
let _e8211 = bitcast<i32>((((_e962 + _e8202) - 1u) >> bitcast<u32>(_e8200)));
let _e8212 = bitcast<i32>((((_e965 + _e8202) - 1u) >> bitcast<u32>(_e8200)));
if _e487 {
phi_68502_ = type_26(_e8212, _e8211);
} else {
phi_68502_ = type_26(_e8211, _e8212);
}
let _e8216 = phi_68502_;
let _e8221 = f32((1i << bitcast<u32>(_e8200)));
let _e8222 = (1f / _e8221);
let _e8224 = ((_e6968 * _e8222) - 0.5f);
let _e8226 = ((_e7061 * _e8222) - 0.5f);
let _e8228 = select(-1f, _e8224, (_e8224 > -1f));
let _e8230 = select(1e6f, _e8228, (_e8228 < 1e6f));
let _e8237 = select(0i, select(select(i32(_e8230), i32(-2147483648), (_e8230 < -2147483600f)), 2147483647i, (_e8230 > 2147483500f)), (_e8230 == _e8230));
let _e8241 = (_e8237 - select(0i, 1i, (_e8230 < f32(_e8237))));
let _e8243 = select(-1f, _e8226, (_e8226 > -1f));
let _e8245 = select(1e6f, _e8243, (_e8243 < 1e6f));
let _e8252 = select(0i, select(select(i32(_e8245), i32(-2147483648), (_e8245 < -2147483600f)), 2147483647i, (_e8245 > 2147483500f)), (_e8245 == _e8245));
let _e8256 = (_e8252 - select(0i, 1i, (_e8245 < f32(_e8252))));
let _e8258 = (_e8224 - f32(_e8241));
let _e8260 = (_e8226 - f32(_e8256));
let _e8261 = (1f - _e8258);
let _e8262 = (1f - _e8260);
let _e8265 = select(_e8241, 0i, (_e8241 < 0i));
let _e8266 = (_e8265 >= _e8216.member);
if _e8266 {
phi_68580_ = (_e8216.member - 1i);
} else {
phi_68580_ = _e8265;
}
let _e8269 = phi_68580_;
let _e8271 = select(_e8256, 0i, (_e8256 < 0i));
let _e8272 = (_e8271 >= _e8216.member_1);
if _e8272 {
phi_68591_ = (_e8216.member_1 - 1i);
} else {
phi_68591_ = _e8271;
}
let _e8275 = phi_68591_;
let _e8279 = (((f32(_e8269) + 0.5f) * _e8221) - 0.5f);
let _e8283 = (((f32(_e8275) + 0.5f) * _e8221) - 0.5f);
if _e487 {
phi_68619_ = type_26(_e8275, _e8269);
} else {
phi_68619_ = type_26(_e8269, _e8275);
}
let _e8289 = phi_68619_;
let _e8292 = (_e6947 == 0u);
if _e8292 {
phi_68670_ = 0u;
} else {
if (_e6947 == 1u) {
phi_68669_ = 0u;
} else {
if (_e6947 == 2u) {
phi_68668_ = _e7613;
} else {
phi_68668_ = select(_e7619, _e7616, (_e6947 == 3u));
}
let _e8298 = phi_68668_;
phi_68669_ = _e8298;
}
let _e8300 = phi_68669_;
phi_68670_ = _e8300;
}
let _e8302 = phi_68670_;
local_56 = (((bitcast<i32>(_e8302) + _e8289.member_1) * _e7610) + _e8289.member);
let _e8307 = local_56;
let _e8309 = select(_e7636, _e8307, (_e8307 < _e7636));
let _e8314 = global_6.member[bitcast<u32>(select(0i, _e8309, (_e8309 > 0i)))];
let _e8319 = (((((select(_e8279, _e8283, _e487) + 0.5f) / _e7141) * 2f) - 1f) * _e7149);
let _e8324 = ((1f - (((select(_e8283, _e8279, _e487) + 0.5f) / _e7142) * 2f)) * _e7157);
let _e8331 = ((_e7160.member * _e8319) + (_e7168.member * _e8324));
let _e8332 = ((_e7160.member_1 * _e8319) + (_e7168.member_1 * _e8324));
let _e8333 = ((_e7160.member_2 * _e8319) + (_e7168.member_2 * _e8324));
let _e8337 = select((_e7183.member + _e8331), _e7183.member, _e7181);
let _e8338 = select((_e7183.member_1 + _e8332), _e7183.member_1, _e7181);
let _e8339 = select((_e7183.member_2 + _e8333), _e7183.member_2, _e7181);
let _e8350 = (((_e8337 * _e8337) + (_e8338 * _e8338)) + (_e8339 * _e8339));
let _e8354 = (1f / sqrt(select(0f, _e8350, (_e8350 > 0f))));
let _e8355 = (_e8337 * _e8354);
let _e8356 = (_e8338 * _e8354);
let _e8357 = (_e8339 * _e8354);
let _e8358 = (_e609 - select(_e7194.member, (_e7194.member + _e8331), _e7181));
let _e8359 = (_e621 - select(_e7194.member_1, (_e7194.member_1 + _e8332), _e7181));
let _e8360 = (_e634 - select(_e7194.member_2, (_e7194.member_2 + _e8333), _e7181));
let _e8365 = (((_e8358 * _e8355) + (_e8359 * _e8356)) + (_e8360 * _e8357));
let _e8370 = (((_e8358 * _e647) + (_e8359 * _e660)) + (_e8360 * _e673));
let _e8375 = (((_e8355 * _e647) + (_e8356 * _e660)) + (_e8357 * _e673));
let _e8378 = ((_e8356 * _e673) - (_e8357 * _e660));
let _e8381 = ((_e8357 * _e647) - (_e8355 * _e673));
let _e8384 = ((_e8355 * _e660) - (_e8356 * _e647));
let _e8389 = (((_e8378 * _e8378) + (_e8381 * _e8381)) + (_e8384 * _e8384));
let _e8392 = (1f / select(1e-9f, _e8389, (_e8389 > 1e-9f)));
let _e8395 = ((_e8365 - (_e8375 * _e8370)) * _e8392);
let _e8398 = (((_e8375 * _e8365) - _e8370) * _e8392);
let _e8404 = select(0f, _e8395, (((_e8398 >= 0f) && (_e8398 < _e725)) && (_e8395 > 0f)));
let _e8406 = (_e8269 << bitcast<u32>(_e8200));
let _e8418 = (_e8241 + 1i);
let _e8421 = select(_e8418, 0i, (_e8418 < 0i));
let _e8422 = (_e8421 >= _e8216.member);
if _e8422 {
phi_69654_ = (_e8216.member - 1i);
} else {
phi_69654_ = _e8421;
}
let _e8425 = phi_69654_;
if _e8272 {
phi_69665_ = (_e8216.member_1 - 1i);
} else {
phi_69665_ = _e8271;
}
let _e8428 = phi_69665_;
let _e8432 = (((f32(_e8425) + 0.5f) * _e8221) - 0.5f);
let _e8436 = (((f32(_e8428) + 0.5f) * _e8221) - 0.5f);
if _e487 {
phi_69693_ = type_26(_e8428, _e8425);
} else {
phi_69693_ = type_26(_e8425, _e8428);
}
let _e8442 = phi_69693_;
if _e8292 {
phi_69744_ = 0u;
} else {
if (_e6947 == 1u) {
phi_69743_ = 0u;
} else {
if (_e6947 == 2u) {
phi_69742_ = _e7613;
} else {
phi_69742_ = select(_e7619, _e7616, (_e6947 == 3u));
}
let _e8450 = phi_69742_;
phi_69743_ = _e8450;
}
let _e8452 = phi_69743_;
phi_69744_ = _e8452;
}
let _e8454 = phi_69744_;
local_54 = (((bitcast<i32>(_e8454) + _e8442.member_1) * _e7610) + _e8442.member);
let _e8459 = local_54;
let _e8461 = select(_e7636, _e8459, (_e8459 < _e7636));
let _e8466 = global_6.member[bitcast<u32>(select(0i, _e8461, (_e8461 > 0i)))];
let _e8471 = (((((select(_e8432, _e8436, _e487) + 0.5f) / _e7141) * 2f) - 1f) * _e7149);
let _e8476 = ((1f - (((select(_e8436, _e8432, _e487) + 0.5f) / _e7142) * 2f)) * _e7157);
let _e8483 = ((_e7160.member * _e8471) + (_e7168.member * _e8476));
let _e8484 = ((_e7160.member_1 * _e8471) + (_e7168.member_1 * _e8476));
let _e8485 = ((_e7160.member_2 * _e8471) + (_e7168.member_2 * _e8476));
let _e8489 = select((_e7183.member + _e8483), _e7183.member, _e7181);
let _e8490 = select((_e7183.member_1 + _e8484), _e7183.member_1, _e7181);
let _e8491 = select((_e7183.member_2 + _e8485), _e7183.member_2, _e7181);
let _e8502 = (((_e8489 * _e8489) + (_e8490 * _e8490)) + (_e8491 * _e8491));
let _e8506 = (1f / sqrt(select(0f, _e8502, (_e8502 > 0f))));
let _e8507 = (_e8489 * _e8506);
let _e8508 = (_e8490 * _e8506);
let _e8509 = (_e8491 * _e8506);
let _e8510 = (_e609 - select(_e7194.member, (_e7194.member + _e8483), _e7181));
let _e8511 = (_e621 - select(_e7194.member_1, (_e7194.member_1 + _e8484), _e7181));
let _e8512 = (_e634 - select(_e7194.member_2, (_e7194.member_2 + _e8485), _e7181));
let _e8517 = (((_e8510 * _e8507) + (_e8511 * _e8508)) + (_e8512 * _e8509));
let _e8522 = (((_e8510 * _e647) + (_e8511 * _e660)) + (_e8512 * _e673));
let _e8527 = (((_e8507 * _e647) + (_e8508 * _e660)) + (_e8509 * _e673));
let _e8530 = ((_e8508 * _e673) - (_e8509 * _e660));
let _e8533 = ((_e8509 * _e647) - (_e8507 * _e673));
let _e8536 = ((_e8507 * _e660) - (_e8508 * _e647));
let _e8541 = (((_e8530 * _e8530) + (_e8533 * _e8533)) + (_e8536 * _e8536));
let _e8544 = (1f / select(1e-9f, _e8541, (_e8541 > 1e-9f)));
let _e8547 = ((_e8517 - (_e8527 * _e8522)) * _e8544);
let _e8550 = (((_e8527 * _e8517) - _e8522) * _e8544);
let _e8556 = select(0f, _e8547, (((_e8550 >= 0f) && (_e8550 < _e725)) && (_e8547 > 0f)));
let _e8558 = (_e8425 << bitcast<u32>(_e8200));
let _e8570 = (_e8256 + 1i);
if _e8266 {
phi_70728_ = (_e8216.member - 1i);
} else {
phi_70728_ = _e8265;
}
let _e8574 = phi_70728_;
let _e8576 = select(_e8570, 0i, (_e8570 < 0i));
let _e8577 = (_e8576 >= _e8216.member_1);
if _e8577 {
phi_70739_ = (_e8216.member_1 - 1i);
} else {
phi_70739_ = _e8576;
}
let _e8580 = phi_70739_;
let _e8584 = (((f32(_e8574) + 0.5f) * _e8221) - 0.5f);
let _e8588 = (((f32(_e8580) + 0.5f) * _e8221) - 0.5f);
if _e487 {
phi_70767_ = type_26(_e8580, _e8574);
} else {
phi_70767_ = type_26(_e8574, _e8580);
}
let _e8594 = phi_70767_;
if _e8292 {
phi_70818_ = 0u;
} else {
if (_e6947 == 1u) {
phi_70817_ = 0u;
} else {
if (_e6947 == 2u) {
phi_70816_ = _e7613;
} else {
phi_70816_ = select(_e7619, _e7616, (_e6947 == 3u));
}
let _e8602 = phi_70816_;
phi_70817_ = _e8602;
}
let _e8604 = phi_70817_;
phi_70818_ = _e8604;
}
let _e8606 = phi_70818_;
local_52 = (((bitcast<i32>(_e8606) + _e8594.member_1) * _e7610) + _e8594.member);
let _e8611 = local_52;
let _e8613 = select(_e7636, _e8611, (_e8611 < _e7636));
let _e8618 = global_6.member[bitcast<u32>(select(0i, _e8613, (_e8613 > 0i)))];
let _e8623 = (((((select(_e8584, _e8588, _e487) + 0.5f) / _e7141) * 2f) - 1f) * _e7149);
let _e8628 = ((1f - (((select(_e8588, _e8584, _e487) + 0.5f) / _e7142) * 2f)) * _e7157);
let _e8635 = ((_e7160.member * _e8623) + (_e7168.member * _e8628));
let _e8636 = ((_e7160.member_1 * _e8623) + (_e7168.member_1 * _e8628));
let _e8637 = ((_e7160.member_2 * _e8623) + (_e7168.member_2 * _e8628));
let _e8641 = select((_e7183.member + _e8635), _e7183.member, _e7181);
let _e8642 = select((_e7183.member_1 + _e8636), _e7183.member_1, _e7181);
let _e8643 = select((_e7183.member_2 + _e8637), _e7183.member_2, _e7181);
let _e8654 = (((_e8641 * _e8641) + (_e8642 * _e8642)) + (_e8643 * _e8643));
let _e8658 = (1f / sqrt(select(0f, _e8654, (_e8654 > 0f))));
let _e8659 = (_e8641 * _e8658);
let _e8660 = (_e8642 * _e8658);
let _e8661 = (_e8643 * _e8658);
let _e8662 = (_e609 - select(_e7194.member, (_e7194.member + _e8635), _e7181));
let _e8663 = (_e621 - select(_e7194.member_1, (_e7194.member_1 + _e8636), _e7181));
let _e8664 = (_e634 - select(_e7194.member_2, (_e7194.member_2 + _e8637), _e7181));
let _e8669 = (((_e8662 * _e8659) + (_e8663 * _e8660)) + (_e8664 * _e8661));
let _e8674 = (((_e8662 * _e647) + (_e8663 * _e660)) + (_e8664 * _e673));
let _e8679 = (((_e8659 * _e647) + (_e8660 * _e660)) + (_e8661 * _e673));
let _e8682 = ((_e8660 * _e673) - (_e8661 * _e660));
let _e8685 = ((_e8661 * _e647) - (_e8659 * _e673));
let _e8688 = ((_e8659 * _e660) - (_e8660 * _e647));
let _e8693 = (((_e8682 * _e8682) + (_e8685 * _e8685)) + (_e8688 * _e8688));
let _e8696 = (1f / select(1e-9f, _e8693, (_e8693 > 1e-9f)));
let _e8699 = ((_e8669 - (_e8679 * _e8674)) * _e8696);
let _e8702 = (((_e8679 * _e8669) - _e8674) * _e8696);
let _e8708 = select(0f, _e8699, (((_e8702 >= 0f) && (_e8702 < _e725)) && (_e8699 > 0f)));
let _e8710 = (_e8574 << bitcast<u32>(_e8200));
if _e8422 {
phi_71802_ = (_e8216.member - 1i);
} else {
phi_71802_ = _e8421;
}
let _e8725 = phi_71802_;
if _e8577 {
phi_71813_ = (_e8216.member_1 - 1i);
} else {
phi_71813_ = _e8576;
}
let _e8728 = phi_71813_;
let _e8732 = (((f32(_e8725) + 0.5f) * _e8221) - 0.5f);
let _e8736 = (((f32(_e8728) + 0.5f) * _e8221) - 0.5f);
if _e487 {
phi_71841_ = type_26(_e8728, _e8725);
} else {
phi_71841_ = type_26(_e8725, _e8728);
}
let _e8742 = phi_71841_;
if _e8292 {
phi_71892_ = 0u;
} else {
if (_e6947 == 1u) {
phi_71891_ = 0u;
} else {
if (_e6947 == 2u) {
phi_71890_ = _e7613;
} else {
phi_71890_ = select(_e7619, _e7616, (_e6947 == 3u));
}
let _e8750 = phi_71890_;
phi_71891_ = _e8750;
}
let _e8752 = phi_71891_;
phi_71892_ = _e8752;
}
let _e8754 = phi_71892_;
local_50 = (((bitcast<i32>(_e8754) + _e8742.member_1) * _e7610) + _e8742.member);
let _e8759 = local_50;
let _e8761 = select(_e7636, _e8759, (_e8759 < _e7636));
let _e8766 = global_6.member[bitcast<u32>(select(0i, _e8761, (_e8761 > 0i)))];
let _e8771 = (((((select(_e8732, _e8736, _e487) + 0.5f) / _e7141) * 2f) - 1f) * _e7149);
let _e8776 = ((1f - (((select(_e8736, _e8732, _e487) + 0.5f) / _e7142) * 2f)) * _e7157);
let _e8783 = ((_e7160.member * _e8771) + (_e7168.member * _e8776));
let _e8784 = ((_e7160.member_1 * _e8771) + (_e7168.member_1 * _e8776));
let _e8785 = ((_e7160.member_2 * _e8771) + (_e7168.member_2 * _e8776));
let _e8789 = select((_e7183.member + _e8783), _e7183.member, _e7181);
let _e8790 = select((_e7183.member_1 + _e8784), _e7183.member_1, _e7181);
let _e8791 = select((_e7183.member_2 + _e8785), _e7183.member_2, _e7181);
let _e8802 = (((_e8789 * _e8789) + (_e8790 * _e8790)) + (_e8791 * _e8791));
let _e8806 = (1f / sqrt(select(0f, _e8802, (_e8802 > 0f))));
let _e8807 = (_e8789 * _e8806);
let _e8808 = (_e8790 * _e8806);
let _e8809 = (_e8791 * _e8806);
let _e8810 = (_e609 - select(_e7194.member, (_e7194.member + _e8783), _e7181));
let _e8811 = (_e621 - select(_e7194.member_1, (_e7194.member_1 + _e8784), _e7181));
let _e8812 = (_e634 - select(_e7194.member_2, (_e7194.member_2 + _e8785), _e7181));
let _e8817 = (((_e8810 * _e8807) + (_e8811 * _e8808)) + (_e8812 * _e8809));
let _e8822 = (((_e8810 * _e647) + (_e8811 * _e660)) + (_e8812 * _e673));
let _e8827 = (((_e8807 * _e647) + (_e8808 * _e660)) + (_e8809 * _e673));
let _e8830 = ((_e8808 * _e673) - (_e8809 * _e660));
let _e8833 = ((_e8809 * _e647) - (_e8807 * _e673));
let _e8836 = ((_e8807 * _e660) - (_e8808 * _e647));
let _e8841 = (((_e8830 * _e8830) + (_e8833 * _e8833)) + (_e8836 * _e8836));
let _e8844 = (1f / select(1e-9f, _e8841, (_e8841 > 1e-9f)));
let _e8847 = ((_e8817 - (_e8827 * _e8822)) * _e8844);
let _e8850 = (((_e8827 * _e8817) - _e8822) * _e8844);
let _e8856 = select(0f, _e8847, (((_e8850 >= 0f) && (_e8850 < _e725)) && (_e8847 > 0f)));
let _e8858 = (_e8725 << bitcast<u32>(_e8200));
let _e8870 = select(((((_e8199 - select(0f, (_e8261 * _e8262), (((select(select(_e800, _e957, (_e8406 >= _e726)), _e879, (_e8406 < _e332)) == _e6947) && (_e8404 > 0f)) && (_e8404 < _e8314)))) - select(0f, (_e8258 * _e8262), (((select(select(_e800, _e957, (_e8558 >= _e726)), _e879, (_e8558 < _e332)) == _e6947) && (_e8556 > 0f)) && (_e8556 < _e8466)))) - select(0f, (_e8261 * _e8260), (((select(select(_e800, _e957, (_e8710 >= _e726)), _e879, (_e8710 < _e332)) == _e6947) && (_e8708 > 0f)) && (_e8708 < _e8618)))) - select(0f, (_e8258 * _e8260), (((select(select(_e800, _e957, (_e8858 >= _e726)), _e879, (_e8858 < _e332)) == _e6947) && (_e8856 > 0f)) && (_e8856 < _e8766)))), _e8199, _e8292);
let _e8871 = (_e6951 & 31u);
let _e8873 = (1u << bitcast<u32>(_e8871));
let _e8882 = bitcast<i32>((((_e962 + _e8873) - 1u) >> bitcast<u32>(_e8871)));
let _e8883 = bitcast<i32>((((_e965 + _e8873) - 1u) >> bitcast<u32>(_e8871)));
if _e487 {
phi_72894_ = type_26(_e8883, _e8882);
} else {
phi_72894_ = type_26(_e8882, _e8883);
}
let _e8887 = phi_72894_;
let _e8892 = f32((1i << bitcast<u32>(_e8871)));
let _e8893 = (1f / _e8892);
let _e8895 = ((_e6968 * _e8893) - 0.5f);
let _e8897 = ((_e7061 * _e8893) - 0.5f);
let _e8899 = select(-1f, _e8895, (_e8895 > -1f));
let _e8901 = select(1e6f, _e8899, (_e8899 < 1e6f));
let _e8908 = select(0i, select(select(i32(_e8901), i32(-2147483648), (_e8901 < -2147483600f)), 2147483647i, (_e8901 > 2147483500f)), (_e8901 == _e8901));
let _e8912 = (_e8908 - select(0i, 1i, (_e8901 < f32(_e8908))));
let _e8914 = select(-1f, _e8897, (_e8897 > -1f));
let _e8916 = select(1e6f, _e8914, (_e8914 < 1e6f));
let _e8923 = select(0i, select(select(i32(_e8916), i32(-2147483648), (_e8916 < -2147483600f)), 2147483647i, (_e8916 > 2147483500f)), (_e8916 == _e8916));
let _e8927 = (_e8923 - select(0i, 1i, (_e8916 < f32(_e8923))));
let _e8929 = (_e8895 - f32(_e8912));
let _e8931 = (_e8897 - f32(_e8927));
let _e8932 = (1f - _e8929);
let _e8933 = (1f - _e8931);
let _e8936 = select(_e8912, 0i, (_e8912 < 0i));
let _e8937 = (_e8936 >= _e8887.member);
if _e8937 {
phi_72972_ = (_e8887.member - 1i);
} else {
phi_72972_ = _e8936;
}
let _e8940 = phi_72972_;
let _e8942 = select(_e8927, 0i, (_e8927 < 0i));
let _e8943 = (_e8942 >= _e8887.member_1);
if _e8943 {
phi_72983_ = (_e8887.member_1 - 1i);
} else {
phi_72983_ = _e8942;
}
let _e8946 = phi_72983_;
let _e8950 = (((f32(_e8940) + 0.5f) * _e8892) - 0.5f);
let _e8954 = (((f32(_e8946) + 0.5f) * _e8892) - 0.5f);
if _e487 {
phi_73011_ = type_26(_e8946, _e8940);
} else {
phi_73011_ = type_26(_e8940, _e8946);
}
let _e8960 = phi_73011_;
let _e8963 = (_e6951 == 0u);
if _e8963 {
phi_73062_ = 0u;
} else {
if (_e6951 == 1u) {
phi_73061_ = 0u;
} else {
if (_e6951 == 2u) {
phi_73060_ = _e7613;
} else {
phi_73060_ = select(_e7619, _e7616, (_e6951 == 3u));
}
let _e8969 = phi_73060_;
phi_73061_ = _e8969;
}
let _e8971 = phi_73061_;
phi_73062_ = _e8971;
}
let _e8973 = phi_73062_;
local_48 = (((bitcast<i32>(_e8973) + _e8960.member_1) * _e7610) + _e8960.member);
let _e8978 = local_48;
let _e8980 = select(_e7636, _e8978, (_e8978 < _e7636));
let _e8985 = global_6.member[bitcast<u32>(select(0i, _e8980, (_e8980 > 0i)))];
let _e8990 = (((((select(_e8950, _e8954, _e487) + 0.5f) / _e7141) * 2f) - 1f) * _e7149);
let _e8995 = ((1f - (((select(_e8954, _e8950, _e487) + 0.5f) / _e7142) * 2f)) * _e7157);
let _e9002 = ((_e7160.member * _e8990) + (_e7168.member * _e8995));
let _e9003 = ((_e7160.member_1 * _e8990) + (_e7168.member_1 * _e8995));
let _e9004 = ((_e7160.member_2 * _e8990) + (_e7168.member_2 * _e8995));
let _e9008 = select((_e7183.member + _e9002), _e7183.member, _e7181);
let _e9009 = select((_e7183.member_1 + _e9003), _e7183.member_1, _e7181);
let _e9010 = select((_e7183.member_2 + _e9004), _e7183.member_2, _e7181);
let _e9021 = (((_e9008 * _e9008) + (_e9009 * _e9009)) + (_e9010 * _e9010));
let _e9025 = (1f / sqrt(select(0f, _e9021, (_e9021 > 0f))));
let _e9026 = (_e9008 * _e9025);
let _e9027 = (_e9009 * _e9025);
let _e9028 = (_e9010 * _e9025);
let _e9029 = (_e609 - select(_e7194.member, (_e7194.member + _e9002), _e7181));
let _e9030 = (_e621 - select(_e7194.member_1, (_e7194.member_1 + _e9003), _e7181));
let _e9031 = (_e634 - select(_e7194.member_2, (_e7194.member_2 + _e9004), _e7181));
let _e9036 = (((_e9029 * _e9026) + (_e9030 * _e9027)) + (_e9031 * _e9028));
let _e9041 = (((_e9029 * _e647) + (_e9030 * _e660)) + (_e9031 * _e673));
let _e9046 = (((_e9026 * _e647) + (_e9027 * _e660)) + (_e9028 * _e673));
let _e9049 = ((_e9027 * _e673) - (_e9028 * _e660));
let _e9052 = ((_e9028 * _e647) - (_e9026 * _e673));
let _e9055 = ((_e9026 * _e660) - (_e9027 * _e647));
let _e9060 = (((_e9049 * _e9049) + (_e9052 * _e9052)) + (_e9055 * _e9055));
let _e9063 = (1f / select(1e-9f, _e9060, (_e9060 > 1e-9f)));
let _e9066 = ((_e9036 - (_e9046 * _e9041)) * _e9063);
let _e9069 = (((_e9046 * _e9036) - _e9041) * _e9063);
let _e9075 = select(0f, _e9066, (((_e9069 >= 0f) && (_e9069 < _e725)) && (_e9066 > 0f)));
let _e9077 = (_e8940 << bitcast<u32>(_e8871));
let _e9089 = (_e8912 + 1i);
let _e9092 = select(_e9089, 0i, (_e9089 < 0i));
let _e9093 = (_e9092 >= _e8887.member);
if _e9093 {
phi_74046_ = (_e8887.member - 1i);
} else {
phi_74046_ = _e9092;
}
let _e9096 = phi_74046_;
if _e8943 {
phi_74057_ = (_e8887.member_1 - 1i);
} else {
phi_74057_ = _e8942;
}
let _e9099 = phi_74057_;
let _e9103 = (((f32(_e9096) + 0.5f) * _e8892) - 0.5f);
let _e9107 = (((f32(_e9099) + 0.5f) * _e8892) - 0.5f);
if _e487 {
phi_74085_ = type_26(_e9099, _e9096);
} else {
phi_74085_ = type_26(_e9096, _e9099);
}
let _e9113 = phi_74085_;
if _e8963 {
phi_74136_ = 0u;
} else {
if (_e6951 == 1u) {
phi_74135_ = 0u;
} else {
if (_e6951 == 2u) {
phi_74134_ = _e7613;
} else {
phi_74134_ = select(_e7619, _e7616, (_e6951 == 3u));
}
let _e9121 = phi_74134_;
phi_74135_ = _e9121;
}
let _e9123 = phi_74135_;
phi_74136_ = _e9123;
}
let _e9125 = phi_74136_;
local_46 = (((bitcast<i32>(_e9125) + _e9113.member_1) * _e7610) + _e9113.member);
let _e9130 = local_46;
let _e9132 = select(_e7636, _e9130, (_e9130 < _e7636));
let _e9137 = global_6.member[bitcast<u32>(select(0i, _e9132, (_e9132 > 0i)))];
let _e9142 = (((((select(_e9103, _e9107, _e487) + 0.5f) / _e7141) * 2f) - 1f) * _e7149);
let _e9147 = ((1f - (((select(_e9107, _e9103, _e487) + 0.5f) / _e7142) * 2f)) * _e7157);
let _e9154 = ((_e7160.member * _e9142) + (_e7168.member * _e9147));
let _e9155 = ((_e7160.member_1 * _e9142) + (_e7168.member_1 * _e9147));
let _e9156 = ((_e7160.member_2 * _e9142) + (_e7168.member_2 * _e9147));
let _e9160 = select((_e7183.member + _e9154), _e7183.member, _e7181);
let _e9161 = select((_e7183.member_1 + _e9155), _e7183.member_1, _e7181);
let _e9162 = select((_e7183.member_2 + _e9156), _e7183.member_2, _e7181);
let _e9173 = (((_e9160 * _e9160) + (_e9161 * _e9161)) + (_e9162 * _e9162));
let _e9177 = (1f / sqrt(select(0f, _e9173, (_e9173 > 0f))));
let _e9178 = (_e9160 * _e9177);
let _e9179 = (_e9161 * _e9177);
let _e9180 = (_e9162 * _e9177);
let _e9181 = (_e609 - select(_e7194.member, (_e7194.member + _e9154), _e7181));
let _e9182 = (_e621 - select(_e7194.member_1, (_e7194.member_1 + _e9155), _e7181));
let _e9183 = (_e634 - select(_e7194.member_2, (_e7194.member_2 + _e9156), _e7181));
let _e9188 = (((_e9181 * _e9178) + (_e9182 * _e9179)) + (_e9183 * _e9180));
let _e9193 = (((_e9181 * _e647) + (_e9182 * _e660)) + (_e9183 * _e673));
let _e9198 = (((_e9178 * _e647) + (_e9179 * _e660)) + (_e9180 * _e673));
let _e9201 = ((_e9179 * _e673) - (_e9180 * _e660));
let _e9204 = ((_e9180 * _e647) - (_e9178 * _e673));
let _e9207 = ((_e9178 * _e660) - (_e9179 * _e647));
let _e9212 = (((_e9201 * _e9201) + (_e9204 * _e9204)) + (_e9207 * _e9207));
let _e9215 = (1f / select(1e-9f, _e9212, (_e9212 > 1e-9f)));
let _e9218 = ((_e9188 - (_e9198 * _e9193)) * _e9215);
let _e9221 = (((_e9198 * _e9188) - _e9193) * _e9215);
let _e9227 = select(0f, _e9218, (((_e9221 >= 0f) && (_e9221 < _e725)) && (_e9218 > 0f)));
let _e9229 = (_e9096 << bitcast<u32>(_e8871));
let _e9241 = (_e8927 + 1i);
if _e8937 {
phi_75120_ = (_e8887.member - 1i);
} else {
phi_75120_ = _e8936;
}
let _e9245 = phi_75120_;
let _e9247 = select(_e9241, 0i, (_e9241 < 0i));
let _e9248 = (_e9247 >= _e8887.member_1);
if _e9248 {
phi_75131_ = (_e8887.member_1 - 1i);
} else {
phi_75131_ = _e9247;
}
let _e9251 = phi_75131_;
let _e9255 = (((f32(_e9245) + 0.5f) * _e8892) - 0.5f);
let _e9259 = (((f32(_e9251) + 0.5f) * _e8892) - 0.5f);
if _e487 {
phi_75159_ = type_26(_e9251, _e9245);
} else {
phi_75159_ = type_26(_e9245, _e9251);
}
let _e9265 = phi_75159_;
if _e8963 {
phi_75210_ = 0u;
} else {
if (_e6951 == 1u) {
phi_75209_ = 0u;
} else {
if (_e6951 == 2u) {
phi_75208_ = _e7613;
} else {
phi_75208_ = select(_e7619, _e7616, (_e6951 == 3u));
}
let _e9273 = phi_75208_;
phi_75209_ = _e9273;
}
let _e9275 = phi_75209_;
phi_75210_ = _e9275;
}
let _e9277 = phi_75210_;
local_44 = (((bitcast<i32>(_e9277) + _e9265.member_1) * _e7610) + _e9265.member);
let _e9282 = local_44;
let _e9284 = select(_e7636, _e9282, (_e9282 < _e7636));
let _e9289 = global_6.member[bitcast<u32>(select(0i, _e9284, (_e9284 > 0i)))];
let _e9294 = (((((select(_e9255, _e9259, _e487) + 0.5f) / _e7141) * 2f) - 1f) * _e7149);
let _e9299 = ((1f - (((select(_e9259, _e9255, _e487) + 0.5f) / _e7142) * 2f)) * _e7157);
let _e9306 = ((_e7160.member * _e9294) + (_e7168.member * _e9299));
let _e9307 = ((_e7160.member_1 * _e9294) + (_e7168.member_1 * _e9299));
let _e9308 = ((_e7160.member_2 * _e9294) + (_e7168.member_2 * _e9299));
let _e9312 = select((_e7183.member + _e9306), _e7183.member, _e7181);
let _e9313 = select((_e7183.member_1 + _e9307), _e7183.member_1, _e7181);
let _e9314 = select((_e7183.member_2 + _e9308), _e7183.member_2, _e7181);
let _e9325 = (((_e9312 * _e9312) + (_e9313 * _e9313)) + (_e9314 * _e9314));
let _e9329 = (1f / sqrt(select(0f, _e9325, (_e9325 > 0f))));
let _e9330 = (_e9312 * _e9329);
let _e9331 = (_e9313 * _e9329);
let _e9332 = (_e9314 * _e9329);
let _e9333 = (_e609 - select(_e7194.member, (_e7194.member + _e9306), _e7181));
let _e9334 = (_e621 - select(_e7194.member_1, (_e7194.member_1 + _e9307), _e7181));
let _e9335 = (_e634 - select(_e7194.member_2, (_e7194.member_2 + _e9308), _e7181));
let _e9340 = (((_e9333 * _e9330) + (_e9334 * _e9331)) + (_e9335 * _e9332));
let _e9345 = (((_e9333 * _e647) + (_e9334 * _e660)) + (_e9335 * _e673));
let _e9350 = (((_e9330 * _e647) + (_e9331 * _e660)) + (_e9332 * _e673));
let _e9353 = ((_e9331 * _e673) - (_e9332 * _e660));
let _e9356 = ((_e9332 * _e647) - (_e9330 * _e673));
let _e9359 = ((_e9330 * _e660) - (_e9331 * _e647));
let _e9364 = (((_e9353 * _e9353) + (_e9356 * _e9356)) + (_e9359 * _e9359));
let _e9367 = (1f / select(1e-9f, _e9364, (_e9364 > 1e-9f)));
let _e9370 = ((_e9340 - (_e9350 * _e9345)) * _e9367);
let _e9373 = (((_e9350 * _e9340) - _e9345) * _e9367);
let _e9379 = select(0f, _e9370, (((_e9373 >= 0f) && (_e9373 < _e725)) && (_e9370 > 0f)));
let _e9381 = (_e9245 << bitcast<u32>(_e8871));
if _e9093 {
phi_76194_ = (_e8887.member - 1i);
} else {
phi_76194_ = _e9092;
}
let _e9396 = phi_76194_;
if _e9248 {
phi_76205_ = (_e8887.member_1 - 1i);
} else {
phi_76205_ = _e9247;
}
let _e9399 = phi_76205_;
let _e9403 = (((f32(_e9396) + 0.5f) * _e8892) - 0.5f);
let _e9407 = (((f32(_e9399) + 0.5f) * _e8892) - 0.5f);
if _e487 {
phi_76233_ = type_26(_e9399, _e9396);
} else {
phi_76233_ = type_26(_e9396, _e9399);
}
let _e9413 = phi_76233_;
if _e8963 {
phi_76284_ = 0u;
} else {
if (_e6951 == 1u) {
phi_76283_ = 0u;
} else {
if (_e6951 == 2u) {
phi_76282_ = _e7613;
} else {
phi_76282_ = select(_e7619, _e7616, (_e6951 == 3u));
}
let _e9421 = phi_76282_;
phi_76283_ = _e9421;
}
let _e9423 = phi_76283_;
phi_76284_ = _e9423;
}
let _e9425 = phi_76284_;
local_42 = (((bitcast<i32>(_e9425) + _e9413.member_1) * _e7610) + _e9413.member);
let _e9430 = local_42;
let _e9432 = select(_e7636, _e9430, (_e9430 < _e7636));
let _e9437 = global_6.member[bitcast<u32>(select(0i, _e9432, (_e9432 > 0i)))];
let _e9442 = (((((select(_e9403, _e9407, _e487) + 0.5f) / _e7141) * 2f) - 1f) * _e7149);
let _e9447 = ((1f - (((select(_e9407, _e9403, _e487) + 0.5f) / _e7142) * 2f)) * _e7157);
let _e9454 = ((_e7160.member * _e9442) + (_e7168.member * _e9447));
let _e9455 = ((_e7160.member_1 * _e9442) + (_e7168.member_1 * _e9447));
let _e9456 = ((_e7160.member_2 * _e9442) + (_e7168.member_2 * _e9447));
let _e9460 = select((_e7183.member + _e9454), _e7183.member, _e7181);
let _e9461 = select((_e7183.member_1 + _e9455), _e7183.member_1, _e7181);
let _e9462 = select((_e7183.member_2 + _e9456), _e7183.member_2, _e7181);
let _e9473 = (((_e9460 * _e9460) + (_e9461 * _e9461)) + (_e9462 * _e9462));
let _e9477 = (1f / sqrt(select(0f, _e9473, (_e9473 > 0f))));
let _e9478 = (_e9460 * _e9477);
let _e9479 = (_e9461 * _e9477);
let _e9480 = (_e9462 * _e9477);
let _e9481 = (_e609 - select(_e7194.member, (_e7194.member + _e9454), _e7181));
let _e9482 = (_e621 - select(_e7194.member_1, (_e7194.member_1 + _e9455), _e7181));
let _e9483 = (_e634 - select(_e7194.member_2, (_e7194.member_2 + _e9456), _e7181));
let _e9488 = (((_e9481 * _e9478) + (_e9482 * _e9479)) + (_e9483 * _e9480));
let _e9493 = (((_e9481 * _e647) + (_e9482 * _e660)) + (_e9483 * _e673));
let _e9498 = (((_e9478 * _e647) + (_e9479 * _e660)) + (_e9480 * _e673));
let _e9501 = ((_e9479 * _e673) - (_e9480 * _e660));
let _e9504 = ((_e9480 * _e647) - (_e9478 * _e673));
let _e9507 = ((_e9478 * _e660) - (_e9479 * _e647));
let _e9512 = (((_e9501 * _e9501) + (_e9504 * _e9504)) + (_e9507 * _e9507));
let _e9515 = (1f / select(1e-9f, _e9512, (_e9512 > 1e-9f)));
let _e9518 = ((_e9488 - (_e9498 * _e9493)) * _e9515);
let _e9521 = (((_e9498 * _e9488) - _e9493) * _e9515);
let _e9527 = select(0f, _e9518, (((_e9521 >= 0f) && (_e9521 < _e725)) && (_e9518 > 0f)));
let _e9529 = (_e9396 << bitcast<u32>(_e8871));
let _e9541 = select(((((_e8870 - select(0f, (_e8932 * _e8933), (((select(select(_e800, _e957, (_e9077 >= _e726)), _e879, (_e9077 < _e332)) == _e6951) && (_e9075 > 0f)) && (_e9075 < _e8985)))) - select(0f, (_e8929 * _e8933), (((select(select(_e800, _e957, (_e9229 >= _e726)), _e879, (_e9229 < _e332)) == _e6951) && (_e9227 > 0f)) && (_e9227 < _e9137)))) - select(0f, (_e8932 * _e8931), (((select(select(_e800, _e957, (_e9381 >= _e726)), _e879, (_e9381 < _e332)) == _e6951) && (_e9379 > 0f)) && (_e9379 < _e9289)))) - select(0f, (_e8929 * _e8931), (((select(select(_e800, _e957, (_e9529 >= _e726)), _e879, (_e9529 < _e332)) == _e6951) && (_e9527 > 0f)) && (_e9527 < _e9437)))), _e8870, _e8963);
if _e487 {
phi_77277_ = type_26(_e7058, _e6966);
} else {
phi_77277_ = type_26(_e6966, _e7058);
}
let _e9556 = phi_77277_;
let _e9559 = (_e7059 && (((_e7514 > 0f) && (_e7514 < _e7138)) && (bitcast<f32>((bitcast<u32>(_e9541) & 2147483647u)) > 1e-6f)));
let _e9562 = global_1.member.member_18.member;
let _e9563 = (((select(_e7084, (1f - _e7084), (_e7069 >= 0f)) - select(_e7103, (1f - _e7103), (_e7088 >= 0f))) * (1f / _e7066)) * _e9562);
let _e9567 = select(0f, (((((_e686 * _e7501.member) * ((1f + (_e7382 * (1f + (_e7382 * (0.5f + (_e7382 * (0.16666667f + (_e7382 * (0.041666668f + (_e7382 * (0.008333334f + (_e7382 * (0.001388889f + (_e7382 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7377 + 127i)) << bitcast<u32>(23i))))) * _e7344) * _e9541) * _e9563), _e9559);
let _e9568 = select(0f, (((((_e699 * _e7501.member_1) * ((1f + (_e7430 * (1f + (_e7430 * (0.5f + (_e7430 * (0.16666667f + (_e7430 * (0.041666668f + (_e7430 * (0.008333334f + (_e7430 * (0.001388889f + (_e7430 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7425 + 127i)) << bitcast<u32>(23i))))) * _e7344) * _e9541) * _e9563), _e9559);
let _e9569 = select(0f, (((((_e712 * _e7501.member_2) * ((1f + (_e7478 * (1f + (_e7478 * (0.5f + (_e7478 * (0.16666667f + (_e7478 * (0.041666668f + (_e7478 * (0.008333334f + (_e7478 * (0.001388889f + (_e7478 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7473 + 127i)) << bitcast<u32>(23i))))) * _e7344) * _e9541) * _e9563), _e9559);
let _e9573 = (bitcast<f32>((bitcast<u32>(_e9567) & 2147483647u)) >= 1073741800f);
let _e9574 = (1f / 1048576f);
let _e9577 = ((_e9567 * select(1f, _e9574, _e9573)) + 0.5f);
let _e9579 = select(-1073741800f, _e9577, (_e9577 > -1073741800f));
let _e9581 = select(1073741800f, _e9579, (_e9579 < 1073741800f));
let _e9588 = select(0i, select(select(i32(_e9581), i32(-2147483648), (_e9581 < -2147483600f)), 2147483647i, (_e9581 > 2147483500f)), (_e9581 == _e9581));
let _e9592 = (_e9588 - select(0i, 1i, (_e9581 < f32(_e9588))));
let _e9593 = select(0i, 20i, _e9573);
let _e9597 = (bitcast<u32>(_e9592) << bitcast<u32>((_e9593 & 31i)));
let _e9604 = bitcast<u32>(((_e9592 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e9593) & 31i))));
let _e9608 = (bitcast<f32>((bitcast<u32>(_e9568) & 2147483647u)) >= 1073741800f);
let _e9611 = ((_e9568 * select(1f, _e9574, _e9608)) + 0.5f);
let _e9613 = select(-1073741800f, _e9611, (_e9611 > -1073741800f));
let _e9615 = select(1073741800f, _e9613, (_e9613 < 1073741800f));
let _e9622 = select(0i, select(select(i32(_e9615), i32(-2147483648), (_e9615 < -2147483600f)), 2147483647i, (_e9615 > 2147483500f)), (_e9615 == _e9615));
let _e9626 = (_e9622 - select(0i, 1i, (_e9615 < f32(_e9622))));
let _e9627 = select(0i, 20i, _e9608);
let _e9631 = (bitcast<u32>(_e9626) << bitcast<u32>((_e9627 & 31i)));
let _e9638 = bitcast<u32>(((_e9626 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e9627) & 31i))));
let _e9642 = (bitcast<f32>((bitcast<u32>(_e9569) & 2147483647u)) >= 1073741800f);
let _e9645 = ((_e9569 * select(1f, _e9574, _e9642)) + 0.5f);
let _e9647 = select(-1073741800f, _e9645, (_e9645 > -1073741800f));
let _e9649 = select(1073741800f, _e9647, (_e9647 < 1073741800f));
let _e9656 = select(0i, select(select(i32(_e9649), i32(-2147483648), (_e9649 < -2147483600f)), 2147483647i, (_e9649 > 2147483500f)), (_e9649 == _e9649));
let _e9660 = (_e9656 - select(0i, 1i, (_e9649 < f32(_e9656))));
let _e9661 = select(0i, 20i, _e9642);
let _e9665 = (bitcast<u32>(_e9660) << bitcast<u32>((_e9661 & 31i)));
let _e9672 = bitcast<u32>(((_e9660 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e9661) & 31i))));
let _e9677 = bitcast<i32>(bitcast<u32>((((_e9556.member_1 * _e966) + _e9556.member) * 6i)));
if ((_e9597 | _e9604) == 0u) {
} else {
let _e9680 = bitcast<u32>(_e9677);
if (_e9680 < _e304) {
let _e9684 = atomicAdd((&global_8.member[_e9680]), _e9597);
phi_77510_ = _e9684;
} else {
phi_77510_ = 0u;
}
let _e9686 = phi_77510_;
let _e9690 = (_e9604 + select(0u, 1u, ((_e9686 + _e9597) < _e9597)));
if (_e9690 == 0u) {
} else {
let _e9692 = (_e9680 + 1u);
if (_e9692 < _e304) {
let _e9696 = atomicAdd((&global_8.member[_e9692]), _e9690);
}
}
}
if ((_e9631 | _e9638) == 0u) {
} else {
let _e9700 = bitcast<u32>((_e9677 + 2i));
if (_e9700 < _e304) {
let _e9704 = atomicAdd((&global_8.member[_e9700]), _e9631);
phi_77540_ = _e9704;
} else {
phi_77540_ = 0u;
}
let _e9706 = phi_77540_;
let _e9710 = (_e9638 + select(0u, 1u, ((_e9706 + _e9631) < _e9631)));
if (_e9710 == 0u) {
} else {
let _e9712 = (_e9700 + 1u);
if (_e9712 < _e304) {
let _e9716 = atomicAdd((&global_8.member[_e9712]), _e9710);
}
}
}
if ((_e9665 | _e9672) == 0u) {
} else {
let _e9720 = bitcast<u32>((_e9677 + 4i));
if (_e9720 < _e304) {
let _e9724 = atomicAdd((&global_8.member[_e9720]), _e9665);
phi_77570_ = _e9724;
} else {
phi_77570_ = 0u;
}
let _e9726 = phi_77570_;
let _e9730 = (_e9672 + select(0u, 1u, ((_e9726 + _e9665) < _e9665)));
if (_e9730 == 0u) {
} else {
let _e9732 = (_e9720 + 1u);
if (_e9732 < _e304) {
let _e9736 = atomicAdd((&global_8.member[_e9732]), _e9730);
}
}
}
phi_62953_ = (_e7056 + 1i);
} else {
phi_62953_ = i32();
}
let _e9739 = phi_62953_;
continue;
continuing {
phi_62952_ = _e9739;
break if !(_e7059);
}
}
phi_62799_ = (_e6963 + 1i);
} else {
phi_62799_ = i32();
}
let _e9743 = phi_62799_;
continue;
continuing {
phi_62798_ = _e9743;
break if !(_e6964);
}
}
}
}
} else {
let _e1018 = (_e800 & 31u);
let _e1020 = (1u << bitcast<u32>(_e1018));
let _e1029 = bitcast<i32>((((_e962 + _e1020) - 1u) >> bitcast<u32>(_e1018)));
let _e1030 = bitcast<i32>((((_e965 + _e1020) - 1u) >> bitcast<u32>(_e1018)));
if _e487 {
phi_77636_ = type_26(_e1030, _e1029);
} else {
phi_77636_ = type_26(_e1029, _e1030);
}
let _e1034 = phi_77636_;
let _e1038 = (_e992 >> bitcast<u32>(_e1018));
if (_e1038 < _e1034.member) {
phi_77711_ = _e1038;
} else {
phi_77711_ = (_e1034.member - 1i);
}
let _e1044 = phi_77711_;
phi_77715_ = type_26(2147483647i, -1i);
phi_77718_ = 0i;
loop {
let _e1047 = phi_77715_;
let _e1049 = phi_77718_;
local_259 = _e1047;
local_260 = _e1047;
let _e1050 = (_e1049 < 16i);
if _e1050 {
let _e1052 = (1i << bitcast<u32>(_e1018));
let _e1053 = f32(_e1052);
let _e1055 = ((4u - _e800) & 31u);
let _e1060 = ((_e1010 >> bitcast<u32>(_e1018)) + (_e1049 & ((1i << bitcast<u32>(_e1055)) - 1i)));
let _e1064 = (((f32(_e1060) + 0.5f) * _e1053) - 0.5f);
let _e1068 = (-(((_e450 * _e1064) + _e476)) / _e463);
let _e1075 = bitcast<f32>((bitcast<u32>(((_e500 * _e1064) + ((_e513 * _e1068) + _e526))) & 2147483647u));
let _e1082 = bitcast<f32>((bitcast<u32>(((_e539 * _e1064) + ((_e552 * _e1068) + _e565))) & 2147483647u));
let _e1087 = (((0.5f * (_e1075 + _e1082)) / _e568) + (0.5f * _e1053));
let _e1088 = (1f / _e1053);
let _e1096 = ((((_e1068 + _e1087) + 0.5f) * _e1088) - 0.5f);
let _e1097 = f32((_e1034.member_1 - 1i));
let _e1098 = (0f - 1f);
let _e1100 = select(_e1098, _e1096, (_e1096 > _e1098));
let _e1102 = select(_e1097, _e1100, (_e1100 < _e1097));
let _e1109 = select(0i, select(select(i32(_e1102), i32(-2147483648), (_e1102 < -2147483600f)), 2147483647i, (_e1102 > 2147483500f)), (_e1102 == _e1102));
let _e1114 = (((((_e1068 - _e1087) + 0.5f) * _e1088) - 0.5f) + 1f);
let _e1115 = (_e1097 + 1f);
let _e1117 = select(0f, _e1114, (_e1114 > 0f));
let _e1119 = select(_e1115, _e1117, (_e1117 < _e1115));
let _e1126 = select(0i, select(select(i32(_e1119), i32(-2147483648), (_e1119 < -2147483600f)), 2147483647i, (_e1119 > 2147483500f)), (_e1119 == _e1119));
let _e1137 = ((1e-4f * _e1053) * _e568);
let _e1139 = select(_e1082, _e1075, (_e1075 > _e1082));
let _e1141 = select(_e1137, _e1139, (_e1139 > _e1137));
let _e1143 = select(_e1082, _e1075, (_e1075 < _e1082));
let _e1145 = select(_e1137, _e1143, (_e1143 > _e1137));
let _e1147 = (0.5f * (_e1141 + _e1145));
let _e1148 = (0.5f / _e1145);
let _e1149 = (1f / _e1141);
phi_77869_ = _e1047;
phi_77872_ = 0i;
loop {
let _e1151 = phi_77869_;
let _e1153 = phi_77872_;
local_269 = _e1151;
let _e1156 = (((_e1126 - select(0i, 1i, (_e1119 < f32(_e1126)))) + (_e1049 >> bitcast<u32>(_e1055))) + (_e1153 << bitcast<u32>(_e1018)));
let _e1157 = (_e1156 <= select(-1i, (_e1109 - select(0i, 1i, (_e1102 < f32(_e1109)))), (_e1060 <= _e1044)));
if _e1157 {
let _e1161 = (((f32(_e1156) + 0.5f) * _e1053) - 0.5f);
let _e1163 = ((_e1161 - _e1068) * _e568);
let _e1164 = (_e568 * _e1053);
let _e1166 = (0.5f * _e1164);
let _e1167 = (_e1163 + _e1166);
let _e1168 = -(_e1167);
let _e1171 = (_e1147 - select(_e1168, _e1167, (_e1167 > _e1168)));
let _e1173 = select(0f, _e1171, (_e1171 > 0f));
let _e1175 = select(_e1145, _e1173, (_e1173 < _e1145));
let _e1178 = (_e1171 - _e1145);
let _e1182 = (((_e1175 * (_e1175 * _e1148)) + select(0f, _e1178, (_e1178 > 0f))) * _e1149);
let _e1186 = (_e1163 - _e1166);
let _e1187 = -(_e1186);
let _e1190 = (_e1147 - select(_e1187, _e1186, (_e1186 > _e1187)));
let _e1192 = select(0f, _e1190, (_e1190 > 0f));
let _e1194 = select(_e1145, _e1192, (_e1192 < _e1145));
let _e1197 = (_e1190 - _e1145);
let _e1201 = (((_e1194 * (_e1194 * _e1148)) + select(0f, _e1197, (_e1197 > 0f))) * _e1149);
if _e487 {
phi_78002_ = type_26(_e1156, _e1060);
} else {
phi_78002_ = type_26(_e1060, _e1156);
}
let _e1212 = phi_78002_;
let _e1218 = bitcast<i32>(((_e962 + 1u) >> bitcast<u32>(1u)));
let _e1221 = global_1.member.member_18.member_9;
let _e1226 = global_1.member.member_18.member_6;
let _e1229 = global_1.member.member_18.member_7;
let _e1232 = global_1.member.member_18.member_8;
if _e1017 {
phi_78053_ = 0u;
} else {
if (_e800 == 1u) {
phi_78052_ = 0u;
} else {
if (_e800 == 2u) {
phi_78051_ = _e1226;
} else {
phi_78051_ = select(_e1232, _e1229, (_e800 == 3u));
}
let _e1238 = phi_78051_;
phi_78052_ = _e1238;
}
let _e1240 = phi_78052_;
phi_78053_ = _e1240;
}
let _e1242 = phi_78053_;
local_40 = (((bitcast<i32>(_e1242) + _e1212.member_1) * _e1218) + _e1212.member);
local_41 = (_e1218 * bitcast<i32>(_e1221));
let _e1247 = local_40;
let _e1249 = (bitcast<i32>(_e296) - 1i);
let _e1251 = select(_e1249, _e1247, (_e1247 < _e1249));
let _e1256 = global_6.member[bitcast<u32>(select(0i, _e1251, (_e1251 > 0i)))];
let _e1257 = local_41;
let _e1258 = local_40;
let _e1259 = (_e1257 + _e1258);
let _e1261 = select(_e1249, _e1259, (_e1259 < _e1249));
let _e1266 = global_6.member[bitcast<u32>(select(0i, _e1261, (_e1261 > 0i)))];
let _e1267 = local_41;
let _e1269 = local_40;
let _e1270 = ((2i * _e1267) + _e1269);
let _e1272 = select(_e1249, _e1270, (_e1270 < _e1249));
let _e1277 = global_6.member[bitcast<u32>(select(0i, _e1272, (_e1272 > 0i)))];
let _e1279 = (_e1052 >> bitcast<u32>(1i));
let _e1282 = ((_e1212.member << bitcast<u32>(_e1018)) + _e1279);
let _e1285 = ((_e1212.member_1 << bitcast<u32>(_e1018)) + _e1279);
let _e1287 = select(_e1282, 0i, (_e1282 < 0i));
if (_e1287 >= _e966) {
phi_78179_ = (_e966 - 1i);
} else {
phi_78179_ = _e1287;
}
let _e1291 = phi_78179_;
let _e1293 = select(_e1285, 0i, (_e1285 < 0i));
if (_e1293 >= _e967) {
phi_78190_ = (_e967 - 1i);
} else {
phi_78190_ = _e1293;
}
let _e1297 = phi_78190_;
local_38 = bitcast<i32>((_e962 * _e965));
local_39 = ((_e1297 * _e966) + _e1291);
let _e1302 = local_38;
let _e1303 = local_39;
let _e1304 = (_e1302 + _e1303);
let _e1306 = (bitcast<i32>(_e293) - 1i);
let _e1308 = select(_e1306, _e1304, (_e1304 < _e1306));
let _e1313 = global_5.member[bitcast<u32>(select(0i, _e1308, (_e1308 > 0i)))];
let _e1322 = global_1.member.member_2.member;
let _e1323 = (((((select(_e1064, _e1161, _e487) + 0.5f) / f32(_e966)) * 2f) - 1f) * _e1322);
let _e1330 = global_1.member.member_2.member_1;
let _e1331 = ((1f - (((select(_e1161, _e1064, _e487) + 0.5f) / f32(_e967)) * 2f)) * _e1330);
let _e1333 = global_1.member.member_3;
let _e1341 = global_1.member.member_4;
let _e1348 = ((_e1333.member * _e1323) + (_e1341.member * _e1331));
let _e1349 = ((_e1333.member_1 * _e1323) + (_e1341.member_1 * _e1331));
let _e1350 = ((_e1333.member_2 * _e1323) + (_e1341.member_2 * _e1331));
let _e1353 = global_1.member.member_2.member_3;
let _e1354 = (_e1353 != 0u);
let _e1356 = global_1.member.member_5;
let _e1363 = select((_e1356.member + _e1348), _e1356.member, _e1354);
let _e1364 = select((_e1356.member_1 + _e1349), _e1356.member_1, _e1354);
let _e1365 = select((_e1356.member_2 + _e1350), _e1356.member_2, _e1354);
let _e1367 = global_1.member.member_6;
let _e1381 = (((_e1363 * _e1363) + (_e1364 * _e1364)) + (_e1365 * _e1365));
let _e1384 = sqrt(select(0f, _e1381, (_e1381 > 0f)));
let _e1385 = (1f / _e1384);
let _e1386 = (_e1363 * _e1385);
let _e1387 = (_e1364 * _e1385);
let _e1388 = (_e1365 * _e1385);
let _e1389 = (_e609 - select(_e1367.member, (_e1367.member + _e1348), _e1354));
let _e1390 = (_e621 - select(_e1367.member_1, (_e1367.member_1 + _e1349), _e1354));
let _e1391 = (_e634 - select(_e1367.member_2, (_e1367.member_2 + _e1350), _e1354));
let _e1396 = (((_e1389 * _e1386) + (_e1390 * _e1387)) + (_e1391 * _e1388));
let _e1401 = (((_e1389 * _e647) + (_e1390 * _e660)) + (_e1391 * _e673));
let _e1406 = (((_e1386 * _e647) + (_e1387 * _e660)) + (_e1388 * _e673));
let _e1409 = ((_e1387 * _e673) - (_e1388 * _e660));
let _e1412 = ((_e1388 * _e647) - (_e1386 * _e673));
let _e1415 = ((_e1386 * _e660) - (_e1387 * _e647));
let _e1420 = (((_e1409 * _e1409) + (_e1412 * _e1412)) + (_e1415 * _e1415));
let _e1423 = (1f / select(1e-9f, _e1420, (_e1420 > 1e-9f)));
let _e1426 = ((_e1396 - (_e1406 * _e1401)) * _e1423);
let _e1429 = (((_e1406 * _e1396) - _e1401) * _e1423);
let _e1435 = -(_e1406);
let _e1438 = global_1.member.member_13.member_2;
let _e1439 = (_e1438 * _e1438);
let _e1443 = ((1f + _e1439) - ((2f * _e1438) * _e1435));
let _e1445 = select(1e-9f, _e1443, (_e1443 > 1e-9f));
let _e1457 = global_1.member.member_13.member_3;
if (_e1457 == 2u) {
let _e1462 = (0.5f - (0.5f * _e1435));
let _e1464 = select(0f, _e1462, (_e1462 > 0f));
let _e1468 = (sqrt(select(0f, _e1464, (_e1464 > 0f))) * 255f);
let _e1469 = (255f - 1f);
let _e1471 = select(0f, _e1468, (_e1468 > 0f));
let _e1473 = select(_e1469, _e1471, (_e1471 < _e1469));
let _e1480 = select(0i, select(select(i32(_e1473), i32(-2147483648), (_e1473 < -2147483600f)), 2147483647i, (_e1473 > 2147483500f)), (_e1473 == _e1473));
let _e1484 = (_e1480 - select(0i, 1i, (_e1473 < f32(_e1480))));
let _e1487 = global_1.member.member_13.member_11;
let _e1488 = bitcast<i32>(_e1487);
let _e1489 = (_e1488 + _e1484);
let _e1491 = (bitcast<i32>(_e299) - 1i);
let _e1493 = select(_e1491, _e1489, (_e1489 < _e1491));
let _e1498 = global_2.member[bitcast<u32>(select(0i, _e1493, (_e1493 > 0i)))];
let _e1500 = (_e1488 + (_e1484 + 1i));
let _e1502 = select(_e1491, _e1500, (_e1500 < _e1491));
let _e1507 = global_2.member[bitcast<u32>(select(0i, _e1502, (_e1502 > 0i)))];
phi_78613_ = (_e1498 + ((_e1507 - _e1498) * (_e1468 - f32(_e1484))));
} else {
phi_78613_ = select(((1f - _e1439) / (_e1445 * sqrt(select(0f, _e1445, (_e1445 > 0f))))), (0.75f * (1f + (_e1435 * _e1435))), (_e1457 == 1u));
}
let _e1514 = phi_78613_;
let _e1517 = (_e1384 * (_e1514 * (0.25f / 3.1415927f)));
let _e1518 = (_e1426 - _e1313);
let _e1521 = (_e1429 + select(0f, _e1518, (_e1518 > 0f)));
let _e1524 = global_1.member.member_13.member;
let _e1529 = -((_e1524.member * _e1521));
let _e1531 = select(-87f, _e1529, (_e1529 > -87f));
let _e1533 = select(88f, _e1531, (_e1531 < 88f));
let _e1535 = ((_e1533 * 1.442695f) + 0.5f);
let _e1537 = select(-127f, _e1535, (_e1535 > -127f));
let _e1539 = select(128f, _e1537, (_e1537 < 128f));
let _e1546 = select(0i, select(select(i32(_e1539), i32(-2147483648), (_e1539 < -2147483600f)), 2147483647i, (_e1539 > 2147483500f)), (_e1539 == _e1539));
let _e1550 = (_e1546 - select(0i, 1i, (_e1539 < f32(_e1546))));
let _e1551 = f32(_e1550);
let _e1555 = ((_e1533 - (_e1551 * 0.6933594f)) - (_e1551 * -2.1219444e-4f));
let _e1577 = -((_e1524.member_1 * _e1521));
let _e1579 = select(-87f, _e1577, (_e1577 > -87f));
let _e1581 = select(88f, _e1579, (_e1579 < 88f));
let _e1583 = ((_e1581 * 1.442695f) + 0.5f);
let _e1585 = select(-127f, _e1583, (_e1583 > -127f));
let _e1587 = select(128f, _e1585, (_e1585 < 128f));
let _e1594 = select(0i, select(select(i32(_e1587), i32(-2147483648), (_e1587 < -2147483600f)), 2147483647i, (_e1587 > 2147483500f)), (_e1587 == _e1587));
let _e1598 = (_e1594 - select(0i, 1i, (_e1587 < f32(_e1594))));
let _e1599 = f32(_e1598);
let _e1603 = ((_e1581 - (_e1599 * 0.6933594f)) - (_e1599 * -2.1219444e-4f));
let _e1625 = -((_e1524.member_2 * _e1521));
let _e1627 = select(-87f, _e1625, (_e1625 > -87f));
let _e1629 = select(88f, _e1627, (_e1627 < 88f));
let _e1631 = ((_e1629 * 1.442695f) + 0.5f);
let _e1633 = select(-127f, _e1631, (_e1631 > -127f));
let _e1635 = select(128f, _e1633, (_e1633 < 128f));
let _e1642 = select(0i, select(select(i32(_e1635), i32(-2147483648), (_e1635 < -2147483600f)), 2147483647i, (_e1635 > 2147483500f)), (_e1635 == _e1635));
let _e1646 = (_e1642 - select(0i, 1i, (_e1635 < f32(_e1642))));
let _e1647 = f32(_e1646);
let _e1651 = ((_e1629 - (_e1647 * 0.6933594f)) - (_e1647 * -2.1219444e-4f));
let _e1674 = global_1.member.member_13.member_1;
let _e1687 = select(0f, _e1426, (((_e1429 >= 0f) && (_e1429 < _e725)) && (_e1426 > 0f)));
let _e1690 = ((_e1687 > 0f) && (_e1687 < _e1256));
if _e487 {
phi_79236_ = type_26(_e1156, _e1060);
} else {
phi_79236_ = type_26(_e1060, _e1156);
}
let _e1714 = phi_79236_;
let _e1717 = (_e1157 && _e1690);
let _e1720 = global_1.member.member_18.member;
let _e1721 = (((select(_e1182, (1f - _e1182), (_e1167 >= 0f)) - select(_e1201, (1f - _e1201), (_e1186 >= 0f))) * (1f / _e1164)) * _e1720);
let _e1725 = select(0f, ((((_e686 * _e1674.member) * ((1f + (_e1555 * (1f + (_e1555 * (0.5f + (_e1555 * (0.16666667f + (_e1555 * (0.041666668f + (_e1555 * (0.008333334f + (_e1555 * (0.001388889f + (_e1555 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1550 + 127i)) << bitcast<u32>(23i))))) * _e1517) * _e1721), _e1717);
let _e1726 = select(0f, ((((_e699 * _e1674.member_1) * ((1f + (_e1603 * (1f + (_e1603 * (0.5f + (_e1603 * (0.16666667f + (_e1603 * (0.041666668f + (_e1603 * (0.008333334f + (_e1603 * (0.001388889f + (_e1603 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1598 + 127i)) << bitcast<u32>(23i))))) * _e1517) * _e1721), _e1717);
let _e1727 = select(0f, ((((_e712 * _e1674.member_2) * ((1f + (_e1651 * (1f + (_e1651 * (0.5f + (_e1651 * (0.16666667f + (_e1651 * (0.041666668f + (_e1651 * (0.008333334f + (_e1651 * (0.001388889f + (_e1651 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1646 + 127i)) << bitcast<u32>(23i))))) * _e1517) * _e1721), _e1717);
let _e1731 = (bitcast<f32>((bitcast<u32>(_e1725) & 2147483647u)) >= 1073741800f);
let _e1732 = (1f / 1048576f);
let _e1735 = ((_e1725 * select(1f, _e1732, _e1731)) + 0.5f);
let _e1737 = select(-1073741800f, _e1735, (_e1735 > -1073741800f));
let _e1739 = select(1073741800f, _e1737, (_e1737 < 1073741800f));
let _e1746 = select(0i, select(select(i32(_e1739), i32(-2147483648), (_e1739 < -2147483600f)), 2147483647i, (_e1739 > 2147483500f)), (_e1739 == _e1739));
let _e1750 = (_e1746 - select(0i, 1i, (_e1739 < f32(_e1746))));
let _e1751 = select(0i, 20i, _e1731);
let _e1755 = (bitcast<u32>(_e1750) << bitcast<u32>((_e1751 & 31i)));
let _e1762 = bitcast<u32>(((_e1750 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e1751) & 31i))));
let _e1766 = (bitcast<f32>((bitcast<u32>(_e1726) & 2147483647u)) >= 1073741800f);
let _e1769 = ((_e1726 * select(1f, _e1732, _e1766)) + 0.5f);
let _e1771 = select(-1073741800f, _e1769, (_e1769 > -1073741800f));
let _e1773 = select(1073741800f, _e1771, (_e1771 < 1073741800f));
let _e1780 = select(0i, select(select(i32(_e1773), i32(-2147483648), (_e1773 < -2147483600f)), 2147483647i, (_e1773 > 2147483500f)), (_e1773 == _e1773));
let _e1784 = (_e1780 - select(0i, 1i, (_e1773 < f32(_e1780))));
let _e1785 = select(0i, 20i, _e1766);
let _e1789 = (bitcast<u32>(_e1784) << bitcast<u32>((_e1785 & 31i)));
let _e1796 = bitcast<u32>(((_e1784 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e1785) & 31i))));
let _e1800 = (bitcast<f32>((bitcast<u32>(_e1727) & 2147483647u)) >= 1073741800f);
let _e1803 = ((_e1727 * select(1f, _e1732, _e1800)) + 0.5f);
let _e1805 = select(-1073741800f, _e1803, (_e1803 > -1073741800f));
let _e1807 = select(1073741800f, _e1805, (_e1805 < 1073741800f));
let _e1814 = select(0i, select(select(i32(_e1807), i32(-2147483648), (_e1807 < -2147483600f)), 2147483647i, (_e1807 > 2147483500f)), (_e1807 == _e1807));
let _e1818 = (_e1814 - select(0i, 1i, (_e1807 < f32(_e1814))));
let _e1819 = select(0i, 20i, _e1800);
let _e1823 = (bitcast<u32>(_e1818) << bitcast<u32>((_e1819 & 31i)));
let _e1830 = bitcast<u32>(((_e1818 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e1819) & 31i))));
let _e1835 = global_1.member.member_18.member_2;
let _e1838 = global_1.member.member_18.member_3;
let _e1841 = global_1.member.member_18.member_4;
let _e1844 = global_1.member.member_18.member_5;
if _e1017 {
phi_79435_ = 0u;
} else {
if (_e800 == 1u) {
phi_79434_ = _e1835;
} else {
if (_e800 == 2u) {
phi_79433_ = _e1838;
} else {
phi_79433_ = select(_e1844, _e1841, (_e800 == 3u));
}
let _e1850 = phi_79433_;
phi_79434_ = _e1850;
}
let _e1852 = phi_79434_;
phi_79435_ = _e1852;
}
let _e1854 = phi_79435_;
let _e1862 = bitcast<i32>(bitcast<u32>((((bitcast<i32>(_e1854) + (_e1714.member_1 * _e1029)) + _e1714.member) * 6i)));
if ((_e1755 | _e1762) == 0u) {
} else {
let _e1865 = bitcast<u32>(_e1862);
if (_e1865 < _e304) {
let _e1869 = atomicAdd((&global_8.member[_e1865]), _e1755);
phi_79469_ = _e1869;
} else {
phi_79469_ = 0u;
}
let _e1871 = phi_79469_;
let _e1875 = (_e1762 + select(0u, 1u, ((_e1871 + _e1755) < _e1755)));
if (_e1875 == 0u) {
} else {
let _e1877 = (_e1865 + 1u);
if (_e1877 < _e304) {
let _e1881 = atomicAdd((&global_8.member[_e1877]), _e1875);
}
}
}
if ((_e1789 | _e1796) == 0u) {
} else {
let _e1885 = bitcast<u32>((_e1862 + 2i));
if (_e1885 < _e304) {
let _e1889 = atomicAdd((&global_8.member[_e1885]), _e1789);
phi_79499_ = _e1889;
} else {
phi_79499_ = 0u;
}
let _e1891 = phi_79499_;
let _e1895 = (_e1796 + select(0u, 1u, ((_e1891 + _e1789) < _e1789)));
if (_e1895 == 0u) {
} else {
let _e1897 = (_e1885 + 1u);
if (_e1897 < _e304) {
let _e1901 = atomicAdd((&global_8.member[_e1897]), _e1895);
}
}
}
if ((_e1823 | _e1830) == 0u) {
} else {
let _e1905 = bitcast<u32>((_e1862 + 4i));
if (_e1905 < _e304) {
let _e1909 = atomicAdd((&global_8.member[_e1905]), _e1823);
phi_79529_ = _e1909;
} else {
phi_79529_ = 0u;
}
let _e1911 = phi_79529_;
let _e1915 = (_e1830 + select(0u, 1u, ((_e1911 + _e1823) < _e1823)));
if (_e1915 == 0u) {
} else {
let _e1917 = (_e1905 + 1u);
if (_e1917 < _e304) {
let _e1921 = atomicAdd((&global_8.member[_e1917]), _e1915);
}
}
}
let _e1922 = bitcast<i32>(bitcast<u32>(select(-1i, _e1156, (_e1157 && (!(((_e1690 && !(((((_e1060 * _e1052) == _e332) && (_e879 != _e800)) || ((((_e1060 + 1i) * _e1052) == _e726) && (_e957 != _e800))))) && ((_e1687 * (1f + (0.02f * _e1053))) < _e1277))) && (_e1687 <= _e1266))))));
if (_e1922 >= 0i) {
phi_79566_ = type_26(select(_e1151.member, _e1922, (_e1922 < _e1151.member)), select(_e1151.member_1, _e1922, (_e1922 > _e1151.member_1)));
} else {
phi_79566_ = _e1151;
}
let _e1932 = phi_79566_;
phi_77870_ = _e1932;
phi_77873_ = (_e1153 + 1i);
} else {
phi_77870_ = type_26();
phi_77873_ = i32();
}
let _e1935 = phi_77870_;
let _e1937 = phi_77873_;
continue;
continuing {
phi_77869_ = _e1935;
phi_77872_ = _e1937;
break if !(_e1157);
}
}
let _e28277 = local_269;
phi_77716_ = _e28277;
phi_77719_ = (_e1049 + 1i);
} else {
phi_77716_ = type_26();
phi_77719_ = i32();
}
let _e1941 = phi_77716_;
let _e1943 = phi_77719_;
continue;
continuing {
phi_77715_ = _e1941;
phi_77718_ = _e1943;
break if !(_e1050);
}
}
let _e1946 = local_259;
let _e1949 = local_260;
if (_e1946.member <= _e1949.member_1) {
let _e1954 = ((_e1949.member_1 + 1i) << bitcast<u32>(_e1018));
if (_e1954 <= _e1016) {
phi_79583_ = (_e1954 - 1i);
} else {
phi_79583_ = _e1016;
}
let _e1958 = phi_79583_;
let _e1960 = (_e1946.member << bitcast<u32>(_e1018));
let _e1962 = select(_e879, 0u, (_e879 == _e800));
let _e1966 = select(_e957, 0u, ((_e957 == _e800) || (_e957 == _e879)));
let _e1974 = ((select(0u, 1u, (_e800 > 0u)) + select(0u, 1u, (_e1962 > 0u))) + select(0u, 1u, (_e1966 > 0u)));
if (_e1974 == 0u) {
phi_79618_ = 0i;
loop {
let _e6194 = phi_79618_;
let _e6195 = (_e6194 < 16i);
if _e6195 {
let _e6197 = (_e1011 + (_e6194 & 15i));
let _e6201 = (((f32(_e6197) + 0.5f) * 1f) - 0.5f);
let _e6205 = (-(((_e450 * _e6201) + _e476)) / _e463);
let _e6212 = bitcast<f32>((bitcast<u32>(((_e500 * _e6201) + ((_e513 * _e6205) + _e526))) & 2147483647u));
let _e6219 = bitcast<f32>((bitcast<u32>(((_e539 * _e6201) + ((_e552 * _e6205) + _e565))) & 2147483647u));
let _e6223 = (((0.5f * (_e6212 + _e6219)) / _e568) + _e751);
let _e6224 = (1f / 1f);
let _e6232 = ((((_e6205 + _e6223) + 0.5f) * _e6224) - 0.5f);
let _e6233 = f32(_e1960);
let _e6234 = f32(_e1958);
let _e6235 = (_e6233 - 1f);
let _e6237 = select(_e6235, _e6232, (_e6232 > _e6235));
let _e6239 = select(_e6234, _e6237, (_e6237 < _e6234));
let _e6246 = select(0i, select(select(i32(_e6239), i32(-2147483648), (_e6239 < -2147483600f)), 2147483647i, (_e6239 > 2147483500f)), (_e6239 == _e6239));
let _e6251 = (((((_e6205 - _e6223) + 0.5f) * _e6224) - 0.5f) + 1f);
let _e6252 = (_e6234 + 1f);
let _e6254 = select(_e6233, _e6251, (_e6251 > _e6233));
let _e6256 = select(_e6252, _e6254, (_e6254 < _e6252));
let _e6263 = select(0i, select(select(i32(_e6256), i32(-2147483648), (_e6256 < -2147483600f)), 2147483647i, (_e6256 > 2147483500f)), (_e6256 == _e6256));
let _e6274 = ((1e-4f * 1f) * _e568);
let _e6276 = select(_e6219, _e6212, (_e6212 > _e6219));
let _e6278 = select(_e6274, _e6276, (_e6276 > _e6274));
let _e6280 = select(_e6219, _e6212, (_e6212 < _e6219));
let _e6282 = select(_e6274, _e6280, (_e6280 > _e6274));
let _e6284 = (0.5f * (_e6278 + _e6282));
let _e6285 = (0.5f / _e6282);
let _e6286 = (1f / _e6278);
phi_79772_ = 0i;
loop {
let _e6288 = phi_79772_;
let _e6290 = (((_e6263 - select(0i, 1i, (_e6256 < f32(_e6263)))) + (_e6194 >> bitcast<u32>(4u))) + bitcast<i32>(_e6288));
let _e6291 = (_e6290 <= select(-1i, (_e6246 - select(0i, 1i, (_e6239 < f32(_e6246)))), (_e6197 <= _e1015)));
if _e6291 {
let _e6297 = (((((f32(_e6290) + 0.5f) * 1f) - 0.5f) - _e6205) * _e568);
let _e6298 = (_e568 * 1f);
let _e6300 = (0.5f * _e6298);
let _e6301 = (_e6297 + _e6300);
let _e6302 = -(_e6301);
let _e6305 = (_e6284 - select(_e6302, _e6301, (_e6301 > _e6302)));
let _e6307 = select(0f, _e6305, (_e6305 > 0f));
let _e6309 = select(_e6282, _e6307, (_e6307 < _e6282));
let _e6312 = (_e6305 - _e6282);
let _e6316 = (((_e6309 * (_e6309 * _e6285)) + select(0f, _e6312, (_e6312 > 0f))) * _e6286);
let _e6320 = (_e6297 - _e6300);
let _e6321 = -(_e6320);
let _e6324 = (_e6284 - select(_e6321, _e6320, (_e6320 > _e6321)));
let _e6326 = select(0f, _e6324, (_e6324 > 0f));
let _e6328 = select(_e6282, _e6326, (_e6326 < _e6282));
let _e6331 = (_e6324 - _e6282);
let _e6335 = (((_e6328 * (_e6328 * _e6285)) + select(0f, _e6331, (_e6331 > 0f))) * _e6286);
if _e487 {
phi_79877_ = type_26(_e6290, _e6197);
} else {
phi_79877_ = type_26(_e6197, _e6290);
}
let _e6344 = phi_79877_;
local_36 = bitcast<i32>((_e962 * _e965));
local_37 = ((_e6344.member_1 * _e966) + _e6344.member);
let _e6351 = local_36;
let _e6352 = local_37;
let _e6353 = (_e6351 + _e6352);
let _e6355 = (bitcast<i32>(_e293) - 1i);
let _e6357 = select(_e6355, _e6353, (_e6353 < _e6355));
let _e6362 = global_5.member[bitcast<u32>(select(0i, _e6357, (_e6357 > 0i)))];
let _e6363 = local_37;
let _e6365 = select(_e6355, _e6363, (_e6363 < _e6355));
let _e6370 = global_5.member[bitcast<u32>(select(0i, _e6365, (_e6365 > 0i)))];
let _e6381 = global_1.member.member_2.member;
let _e6382 = (((((f32(_e6344.member) + 0.5f) / f32(_e966)) * 2f) - 1f) * _e6381);
let _e6389 = global_1.member.member_2.member_1;
let _e6390 = ((1f - (((f32(_e6344.member_1) + 0.5f) / f32(_e967)) * 2f)) * _e6389);
let _e6392 = global_1.member.member_3;
let _e6400 = global_1.member.member_4;
let _e6407 = ((_e6392.member * _e6382) + (_e6400.member * _e6390));
let _e6408 = ((_e6392.member_1 * _e6382) + (_e6400.member_1 * _e6390));
let _e6409 = ((_e6392.member_2 * _e6382) + (_e6400.member_2 * _e6390));
let _e6412 = global_1.member.member_2.member_3;
let _e6413 = (_e6412 != 0u);
let _e6415 = global_1.member.member_5;
let _e6422 = select((_e6415.member + _e6407), _e6415.member, _e6413);
let _e6423 = select((_e6415.member_1 + _e6408), _e6415.member_1, _e6413);
let _e6424 = select((_e6415.member_2 + _e6409), _e6415.member_2, _e6413);
let _e6426 = global_1.member.member_6;
let _e6440 = (((_e6422 * _e6422) + (_e6423 * _e6423)) + (_e6424 * _e6424));
let _e6443 = sqrt(select(0f, _e6440, (_e6440 > 0f)));
let _e6444 = (1f / _e6443);
let _e6445 = (_e6422 * _e6444);
let _e6446 = (_e6423 * _e6444);
let _e6447 = (_e6424 * _e6444);
let _e6448 = (_e609 - select(_e6426.member, (_e6426.member + _e6407), _e6413));
let _e6449 = (_e621 - select(_e6426.member_1, (_e6426.member_1 + _e6408), _e6413));
let _e6450 = (_e634 - select(_e6426.member_2, (_e6426.member_2 + _e6409), _e6413));
let _e6455 = (((_e6448 * _e6445) + (_e6449 * _e6446)) + (_e6450 * _e6447));
let _e6460 = (((_e6448 * _e647) + (_e6449 * _e660)) + (_e6450 * _e673));
let _e6465 = (((_e6445 * _e647) + (_e6446 * _e660)) + (_e6447 * _e673));
let _e6468 = ((_e6446 * _e673) - (_e6447 * _e660));
let _e6471 = ((_e6447 * _e647) - (_e6445 * _e673));
let _e6474 = ((_e6445 * _e660) - (_e6446 * _e647));
let _e6479 = (((_e6468 * _e6468) + (_e6471 * _e6471)) + (_e6474 * _e6474));
let _e6482 = (1f / select(1e-9f, _e6479, (_e6479 > 1e-9f)));
let _e6485 = ((_e6455 - (_e6465 * _e6460)) * _e6482);
let _e6488 = (((_e6465 * _e6455) - _e6460) * _e6482);
let _e6494 = -(_e6465);
let _e6497 = global_1.member.member_13.member_2;
let _e6498 = (_e6497 * _e6497);
let _e6502 = ((1f + _e6498) - ((2f * _e6497) * _e6494));
let _e6504 = select(1e-9f, _e6502, (_e6502 > 1e-9f));
let _e6516 = global_1.member.member_13.member_3;
if (_e6516 == 2u) {
let _e6521 = (0.5f - (0.5f * _e6494));
let _e6523 = select(0f, _e6521, (_e6521 > 0f));
let _e6527 = (sqrt(select(0f, _e6523, (_e6523 > 0f))) * 255f);
let _e6528 = (255f - 1f);
let _e6530 = select(0f, _e6527, (_e6527 > 0f));
let _e6532 = select(_e6528, _e6530, (_e6530 < _e6528));
let _e6539 = select(0i, select(select(i32(_e6532), i32(-2147483648), (_e6532 < -2147483600f)), 2147483647i, (_e6532 > 2147483500f)), (_e6532 == _e6532));
let _e6543 = (_e6539 - select(0i, 1i, (_e6532 < f32(_e6539))));
let _e6546 = global_1.member.member_13.member_11;
let _e6547 = bitcast<i32>(_e6546);
let _e6548 = (_e6547 + _e6543);
let _e6550 = (bitcast<i32>(_e299) - 1i);
let _e6552 = select(_e6550, _e6548, (_e6548 < _e6550));
let _e6557 = global_2.member[bitcast<u32>(select(0i, _e6552, (_e6552 > 0i)))];
let _e6559 = (_e6547 + (_e6543 + 1i));
let _e6561 = select(_e6550, _e6559, (_e6559 < _e6550));
let _e6566 = global_2.member[bitcast<u32>(select(0i, _e6561, (_e6561 > 0i)))];
phi_80304_ = (_e6557 + ((_e6566 - _e6557) * (_e6527 - f32(_e6543))));
} else {
phi_80304_ = select(((1f - _e6498) / (_e6504 * sqrt(select(0f, _e6504, (_e6504 > 0f))))), (0.75f * (1f + (_e6494 * _e6494))), (_e6516 == 1u));
}
let _e6573 = phi_80304_;
let _e6576 = (_e6443 * (_e6573 * (0.25f / 3.1415927f)));
let _e6577 = (_e6485 - _e6362);
let _e6580 = (_e6488 + select(0f, _e6577, (_e6577 > 0f)));
let _e6583 = global_1.member.member_13.member;
let _e6588 = -((_e6583.member * _e6580));
let _e6590 = select(-87f, _e6588, (_e6588 > -87f));
let _e6592 = select(88f, _e6590, (_e6590 < 88f));
let _e6594 = ((_e6592 * 1.442695f) + 0.5f);
let _e6596 = select(-127f, _e6594, (_e6594 > -127f));
let _e6598 = select(128f, _e6596, (_e6596 < 128f));
let _e6605 = select(0i, select(select(i32(_e6598), i32(-2147483648), (_e6598 < -2147483600f)), 2147483647i, (_e6598 > 2147483500f)), (_e6598 == _e6598));
let _e6609 = (_e6605 - select(0i, 1i, (_e6598 < f32(_e6605))));
let _e6610 = f32(_e6609);
let _e6614 = ((_e6592 - (_e6610 * 0.6933594f)) - (_e6610 * -2.1219444e-4f));
let _e6636 = -((_e6583.member_1 * _e6580));
let _e6638 = select(-87f, _e6636, (_e6636 > -87f));
let _e6640 = select(88f, _e6638, (_e6638 < 88f));
let _e6642 = ((_e6640 * 1.442695f) + 0.5f);
let _e6644 = select(-127f, _e6642, (_e6642 > -127f));
let _e6646 = select(128f, _e6644, (_e6644 < 128f));
let _e6653 = select(0i, select(select(i32(_e6646), i32(-2147483648), (_e6646 < -2147483600f)), 2147483647i, (_e6646 > 2147483500f)), (_e6646 == _e6646));
let _e6657 = (_e6653 - select(0i, 1i, (_e6646 < f32(_e6653))));
let _e6658 = f32(_e6657);
let _e6662 = ((_e6640 - (_e6658 * 0.6933594f)) - (_e6658 * -2.1219444e-4f));
let _e6684 = -((_e6583.member_2 * _e6580));
let _e6686 = select(-87f, _e6684, (_e6684 > -87f));
let _e6688 = select(88f, _e6686, (_e6686 < 88f));
let _e6690 = ((_e6688 * 1.442695f) + 0.5f);
let _e6692 = select(-127f, _e6690, (_e6690 > -127f));
let _e6694 = select(128f, _e6692, (_e6692 < 128f));
let _e6701 = select(0i, select(select(i32(_e6694), i32(-2147483648), (_e6694 < -2147483600f)), 2147483647i, (_e6694 > 2147483500f)), (_e6694 == _e6694));
let _e6705 = (_e6701 - select(0i, 1i, (_e6694 < f32(_e6701))));
let _e6706 = f32(_e6705);
let _e6710 = ((_e6688 - (_e6706 * 0.6933594f)) - (_e6706 * -2.1219444e-4f));
let _e6733 = global_1.member.member_13.member_1;
let _e6746 = select(0f, _e6485, (((_e6488 >= 0f) && (_e6488 < _e725)) && (_e6485 > 0f)));
if _e487 {
phi_80906_ = type_26(_e6290, _e6197);
} else {
phi_80906_ = type_26(_e6197, _e6290);
}
let _e6757 = phi_80906_;
let _e6760 = (_e6291 && (((_e6746 > 0f) && (_e6746 < _e6370)) && true));
let _e6763 = global_1.member.member_18.member;
let _e6764 = (((select(_e6316, (1f - _e6316), (_e6301 >= 0f)) - select(_e6335, (1f - _e6335), (_e6320 >= 0f))) * (1f / _e6298)) * _e6763);
let _e6768 = select(0f, (((((_e686 * _e6733.member) * ((1f + (_e6614 * (1f + (_e6614 * (0.5f + (_e6614 * (0.16666667f + (_e6614 * (0.041666668f + (_e6614 * (0.008333334f + (_e6614 * (0.001388889f + (_e6614 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6609 + 127i)) << bitcast<u32>(23i))))) * _e6576) * 1f) * _e6764), _e6760);
let _e6769 = select(0f, (((((_e699 * _e6733.member_1) * ((1f + (_e6662 * (1f + (_e6662 * (0.5f + (_e6662 * (0.16666667f + (_e6662 * (0.041666668f + (_e6662 * (0.008333334f + (_e6662 * (0.001388889f + (_e6662 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6657 + 127i)) << bitcast<u32>(23i))))) * _e6576) * 1f) * _e6764), _e6760);
let _e6770 = select(0f, (((((_e712 * _e6733.member_2) * ((1f + (_e6710 * (1f + (_e6710 * (0.5f + (_e6710 * (0.16666667f + (_e6710 * (0.041666668f + (_e6710 * (0.008333334f + (_e6710 * (0.001388889f + (_e6710 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6705 + 127i)) << bitcast<u32>(23i))))) * _e6576) * 1f) * _e6764), _e6760);
let _e6774 = (bitcast<f32>((bitcast<u32>(_e6768) & 2147483647u)) >= 1073741800f);
let _e6775 = (1f / 1048576f);
let _e6778 = ((_e6768 * select(1f, _e6775, _e6774)) + 0.5f);
let _e6780 = select(-1073741800f, _e6778, (_e6778 > -1073741800f));
let _e6782 = select(1073741800f, _e6780, (_e6780 < 1073741800f));
let _e6789 = select(0i, select(select(i32(_e6782), i32(-2147483648), (_e6782 < -2147483600f)), 2147483647i, (_e6782 > 2147483500f)), (_e6782 == _e6782));
let _e6793 = (_e6789 - select(0i, 1i, (_e6782 < f32(_e6789))));
let _e6794 = select(0i, 20i, _e6774);
let _e6798 = (bitcast<u32>(_e6793) << bitcast<u32>((_e6794 & 31i)));
let _e6805 = bitcast<u32>(((_e6793 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e6794) & 31i))));
let _e6809 = (bitcast<f32>((bitcast<u32>(_e6769) & 2147483647u)) >= 1073741800f);
let _e6812 = ((_e6769 * select(1f, _e6775, _e6809)) + 0.5f);
let _e6814 = select(-1073741800f, _e6812, (_e6812 > -1073741800f));
let _e6816 = select(1073741800f, _e6814, (_e6814 < 1073741800f));
let _e6823 = select(0i, select(select(i32(_e6816), i32(-2147483648), (_e6816 < -2147483600f)), 2147483647i, (_e6816 > 2147483500f)), (_e6816 == _e6816));
let _e6827 = (_e6823 - select(0i, 1i, (_e6816 < f32(_e6823))));
let _e6828 = select(0i, 20i, _e6809);
let _e6832 = (bitcast<u32>(_e6827) << bitcast<u32>((_e6828 & 31i)));
let _e6839 = bitcast<u32>(((_e6827 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e6828) & 31i))));
let _e6843 = (bitcast<f32>((bitcast<u32>(_e6770) & 2147483647u)) >= 1073741800f);
let _e6846 = ((_e6770 * select(1f, _e6775, _e6843)) + 0.5f);
let _e6848 = select(-1073741800f, _e6846, (_e6846 > -1073741800f));
let _e6850 = select(1073741800f, _e6848, (_e6848 < 1073741800f));
let _e6857 = select(0i, select(select(i32(_e6850), i32(-2147483648), (_e6850 < -2147483600f)), 2147483647i, (_e6850 > 2147483500f)), (_e6850 == _e6850));
let _e6861 = (_e6857 - select(0i, 1i, (_e6850 < f32(_e6857))));
let _e6862 = select(0i, 20i, _e6843);
let _e6866 = (bitcast<u32>(_e6861) << bitcast<u32>((_e6862 & 31i)));
let _e6873 = bitcast<u32>(((_e6861 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e6862) & 31i))));
let _e6878 = bitcast<i32>(bitcast<u32>((((_e6757.member_1 * _e966) + _e6757.member) * 6i)));
if ((_e6798 | _e6805) == 0u) {
} else {
let _e6881 = bitcast<u32>(_e6878);
if (_e6881 < _e304) {
let _e6885 = atomicAdd((&global_8.member[_e6881]), _e6798);
phi_81139_ = _e6885;
} else {
phi_81139_ = 0u;
}
let _e6887 = phi_81139_;
let _e6891 = (_e6805 + select(0u, 1u, ((_e6887 + _e6798) < _e6798)));
if (_e6891 == 0u) {
} else {
let _e6893 = (_e6881 + 1u);
if (_e6893 < _e304) {
let _e6897 = atomicAdd((&global_8.member[_e6893]), _e6891);
}
}
}
if ((_e6832 | _e6839) == 0u) {
} else {
let _e6901 = bitcast<u32>((_e6878 + 2i));
if (_e6901 < _e304) {
let _e6905 = atomicAdd((&global_8.member[_e6901]), _e6832);
phi_81169_ = _e6905;
} else {
phi_81169_ = 0u;
}
let _e6907 = phi_81169_;
let _e6911 = (_e6839 + select(0u, 1u, ((_e6907 + _e6832) < _e6832)));
if (_e6911 == 0u) {
} else {
let _e6913 = (_e6901 + 1u);
if (_e6913 < _e304) {
let _e6917 = atomicAdd((&global_8.member[_e6913]), _e6911);
}
}
}
if ((_e6866 | _e6873) == 0u) {
} else {
let _e6921 = bitcast<u32>((_e6878 + 4i));
if (_e6921 < _e304) {
let _e6925 = atomicAdd((&global_8.member[_e6921]), _e6866);
phi_81199_ = _e6925;
} else {
phi_81199_ = 0u;
}
let _e6927 = phi_81199_;
let _e6931 = (_e6873 + select(0u, 1u, ((_e6927 + _e6866) < _e6866)));
if (_e6931 == 0u) {
} else {
let _e6933 = (_e6921 + 1u);
if (_e6933 < _e304) {
let _e6937 = atomicAdd((&global_8.member[_e6933]), _e6931);
}
}
}
phi_79773_ = (_e6288 + 1i);
} else {
phi_79773_ = i32();
}
let _e6940 = phi_79773_;
continue;
continuing {
phi_79772_ = _e6940;
break if !(_e6291);
}
}
phi_79619_ = (_e6194 + 1i);
} else {
phi_79619_ = i32();
}
let _e6944 = phi_79619_;
continue;
continuing {
phi_79618_ = _e6944;
break if !(_e6195);
}
}
} else {
if (_e1974 == 1u) {
phi_81248_ = 0i;
loop {
let _e4749 = phi_81248_;
let _e4750 = (_e4749 < 16i);
if _e4750 {
let _e4752 = (_e1011 + (_e4749 & 15i));
let _e4754 = (f32(_e4752) + 0.5f);
let _e4756 = ((_e4754 * 1f) - 0.5f);
let _e4760 = (-(((_e450 * _e4756) + _e476)) / _e463);
let _e4767 = bitcast<f32>((bitcast<u32>(((_e500 * _e4756) + ((_e513 * _e4760) + _e526))) & 2147483647u));
let _e4774 = bitcast<f32>((bitcast<u32>(((_e539 * _e4756) + ((_e552 * _e4760) + _e565))) & 2147483647u));
let _e4778 = (((0.5f * (_e4767 + _e4774)) / _e568) + _e751);
let _e4779 = (1f / 1f);
let _e4787 = ((((_e4760 + _e4778) + 0.5f) * _e4779) - 0.5f);
let _e4788 = f32(_e1960);
let _e4789 = f32(_e1958);
let _e4790 = (_e4788 - 1f);
let _e4792 = select(_e4790, _e4787, (_e4787 > _e4790));
let _e4794 = select(_e4789, _e4792, (_e4792 < _e4789));
let _e4801 = select(0i, select(select(i32(_e4794), i32(-2147483648), (_e4794 < -2147483600f)), 2147483647i, (_e4794 > 2147483500f)), (_e4794 == _e4794));
let _e4806 = (((((_e4760 - _e4778) + 0.5f) * _e4779) - 0.5f) + 1f);
let _e4807 = (_e4789 + 1f);
let _e4809 = select(_e4788, _e4806, (_e4806 > _e4788));
let _e4811 = select(_e4807, _e4809, (_e4809 < _e4807));
let _e4818 = select(0i, select(select(i32(_e4811), i32(-2147483648), (_e4811 < -2147483600f)), 2147483647i, (_e4811 > 2147483500f)), (_e4811 == _e4811));
let _e4829 = ((1e-4f * 1f) * _e568);
let _e4831 = select(_e4774, _e4767, (_e4767 > _e4774));
let _e4833 = select(_e4829, _e4831, (_e4831 > _e4829));
let _e4835 = select(_e4774, _e4767, (_e4767 < _e4774));
let _e4837 = select(_e4829, _e4835, (_e4835 > _e4829));
let _e4839 = (0.5f * (_e4833 + _e4837));
let _e4840 = (0.5f / _e4837);
let _e4841 = (1f / _e4833);
phi_81402_ = 0i;
loop {
let _e4843 = phi_81402_;
let _e4845 = (((_e4818 - select(0i, 1i, (_e4811 < f32(_e4818)))) + (_e4749 >> bitcast<u32>(4u))) + bitcast<i32>(_e4843));
let _e4846 = (_e4845 <= select(-1i, (_e4801 - select(0i, 1i, (_e4794 < f32(_e4801)))), (_e4752 <= _e1015)));
if _e4846 {
let _e4848 = (f32(_e4845) + 0.5f);
let _e4852 = ((((_e4848 * 1f) - 0.5f) - _e4760) * _e568);
let _e4853 = (_e568 * 1f);
let _e4855 = (0.5f * _e4853);
let _e4856 = (_e4852 + _e4855);
let _e4857 = -(_e4856);
let _e4860 = (_e4839 - select(_e4857, _e4856, (_e4856 > _e4857)));
let _e4862 = select(0f, _e4860, (_e4860 > 0f));
let _e4864 = select(_e4837, _e4862, (_e4862 < _e4837));
let _e4867 = (_e4860 - _e4837);
let _e4871 = (((_e4864 * (_e4864 * _e4840)) + select(0f, _e4867, (_e4867 > 0f))) * _e4841);
let _e4875 = (_e4852 - _e4855);
let _e4876 = -(_e4875);
let _e4879 = (_e4839 - select(_e4876, _e4875, (_e4875 > _e4876)));
let _e4881 = select(0f, _e4879, (_e4879 > 0f));
let _e4883 = select(_e4837, _e4881, (_e4881 < _e4837));
let _e4886 = (_e4879 - _e4837);
let _e4890 = (((_e4883 * (_e4883 * _e4840)) + select(0f, _e4886, (_e4886 > 0f))) * _e4841);
if _e487 {
phi_81507_ = type_26(_e4845, _e4752);
} else {
phi_81507_ = type_26(_e4752, _e4845);
}
let _e4899 = phi_81507_;
local_34 = bitcast<i32>((_e962 * _e965));
local_35 = ((_e4899.member_1 * _e966) + _e4899.member);
let _e4906 = local_34;
let _e4907 = local_35;
let _e4908 = (_e4906 + _e4907);
let _e4910 = (bitcast<i32>(_e293) - 1i);
let _e4912 = select(_e4910, _e4908, (_e4908 < _e4910));
let _e4917 = global_5.member[bitcast<u32>(select(0i, _e4912, (_e4912 > 0i)))];
let _e4918 = local_35;
let _e4920 = select(_e4910, _e4918, (_e4918 < _e4910));
let _e4925 = global_5.member[bitcast<u32>(select(0i, _e4920, (_e4920 > 0i)))];
let _e4928 = f32(_e966);
let _e4929 = f32(_e967);
let _e4936 = global_1.member.member_2.member;
let _e4937 = (((((f32(_e4899.member) + 0.5f) / _e4928) * 2f) - 1f) * _e4936);
let _e4944 = global_1.member.member_2.member_1;
let _e4945 = ((1f - (((f32(_e4899.member_1) + 0.5f) / _e4929) * 2f)) * _e4944);
let _e4947 = global_1.member.member_3;
let _e4955 = global_1.member.member_4;
let _e4962 = ((_e4947.member * _e4937) + (_e4955.member * _e4945));
let _e4963 = ((_e4947.member_1 * _e4937) + (_e4955.member_1 * _e4945));
let _e4964 = ((_e4947.member_2 * _e4937) + (_e4955.member_2 * _e4945));
let _e4967 = global_1.member.member_2.member_3;
let _e4968 = (_e4967 != 0u);
let _e4970 = global_1.member.member_5;
let _e4977 = select((_e4970.member + _e4962), _e4970.member, _e4968);
let _e4978 = select((_e4970.member_1 + _e4963), _e4970.member_1, _e4968);
let _e4979 = select((_e4970.member_2 + _e4964), _e4970.member_2, _e4968);
let _e4981 = global_1.member.member_6;
let _e4995 = (((_e4977 * _e4977) + (_e4978 * _e4978)) + (_e4979 * _e4979));
let _e4998 = sqrt(select(0f, _e4995, (_e4995 > 0f)));
let _e4999 = (1f / _e4998);
let _e5000 = (_e4977 * _e4999);
let _e5001 = (_e4978 * _e4999);
let _e5002 = (_e4979 * _e4999);
let _e5003 = (_e609 - select(_e4981.member, (_e4981.member + _e4962), _e4968));
let _e5004 = (_e621 - select(_e4981.member_1, (_e4981.member_1 + _e4963), _e4968));
let _e5005 = (_e634 - select(_e4981.member_2, (_e4981.member_2 + _e4964), _e4968));
let _e5010 = (((_e5003 * _e5000) + (_e5004 * _e5001)) + (_e5005 * _e5002));
let _e5015 = (((_e5003 * _e647) + (_e5004 * _e660)) + (_e5005 * _e673));
let _e5020 = (((_e5000 * _e647) + (_e5001 * _e660)) + (_e5002 * _e673));
let _e5023 = ((_e5001 * _e673) - (_e5002 * _e660));
let _e5026 = ((_e5002 * _e647) - (_e5000 * _e673));
let _e5029 = ((_e5000 * _e660) - (_e5001 * _e647));
let _e5034 = (((_e5023 * _e5023) + (_e5026 * _e5026)) + (_e5029 * _e5029));
let _e5037 = (1f / select(1e-9f, _e5034, (_e5034 > 1e-9f)));
let _e5040 = ((_e5010 - (_e5020 * _e5015)) * _e5037);
let _e5043 = (((_e5020 * _e5010) - _e5015) * _e5037);
let _e5049 = -(_e5020);
let _e5052 = global_1.member.member_13.member_2;
let _e5053 = (_e5052 * _e5052);
let _e5057 = ((1f + _e5053) - ((2f * _e5052) * _e5049));
let _e5059 = select(1e-9f, _e5057, (_e5057 > 1e-9f));
let _e5071 = global_1.member.member_13.member_3;
if (_e5071 == 2u) {
let _e5076 = (0.5f - (0.5f * _e5049));
let _e5078 = select(0f, _e5076, (_e5076 > 0f));
let _e5082 = (sqrt(select(0f, _e5078, (_e5078 > 0f))) * 255f);
let _e5083 = (255f - 1f);
let _e5085 = select(0f, _e5082, (_e5082 > 0f));
let _e5087 = select(_e5083, _e5085, (_e5085 < _e5083));
let _e5094 = select(0i, select(select(i32(_e5087), i32(-2147483648), (_e5087 < -2147483600f)), 2147483647i, (_e5087 > 2147483500f)), (_e5087 == _e5087));
let _e5098 = (_e5094 - select(0i, 1i, (_e5087 < f32(_e5094))));
let _e5101 = global_1.member.member_13.member_11;
let _e5102 = bitcast<i32>(_e5101);
let _e5103 = (_e5102 + _e5098);
let _e5105 = (bitcast<i32>(_e299) - 1i);
let _e5107 = select(_e5105, _e5103, (_e5103 < _e5105));
let _e5112 = global_2.member[bitcast<u32>(select(0i, _e5107, (_e5107 > 0i)))];
let _e5114 = (_e5102 + (_e5098 + 1i));
let _e5116 = select(_e5105, _e5114, (_e5114 < _e5105));
let _e5121 = global_2.member[bitcast<u32>(select(0i, _e5116, (_e5116 > 0i)))];
phi_81934_ = (_e5112 + ((_e5121 - _e5112) * (_e5082 - f32(_e5098))));
} else {
phi_81934_ = select(((1f - _e5053) / (_e5059 * sqrt(select(0f, _e5059, (_e5059 > 0f))))), (0.75f * (1f + (_e5049 * _e5049))), (_e5071 == 1u));
}
let _e5128 = phi_81934_;
let _e5131 = (_e4998 * (_e5128 * (0.25f / 3.1415927f)));
let _e5132 = (_e5040 - _e4917);
let _e5135 = (_e5043 + select(0f, _e5132, (_e5132 > 0f)));
let _e5138 = global_1.member.member_13.member;
let _e5143 = -((_e5138.member * _e5135));
let _e5145 = select(-87f, _e5143, (_e5143 > -87f));
let _e5147 = select(88f, _e5145, (_e5145 < 88f));
let _e5149 = ((_e5147 * 1.442695f) + 0.5f);
let _e5151 = select(-127f, _e5149, (_e5149 > -127f));
let _e5153 = select(128f, _e5151, (_e5151 < 128f));
let _e5160 = select(0i, select(select(i32(_e5153), i32(-2147483648), (_e5153 < -2147483600f)), 2147483647i, (_e5153 > 2147483500f)), (_e5153 == _e5153));
let _e5164 = (_e5160 - select(0i, 1i, (_e5153 < f32(_e5160))));
let _e5165 = f32(_e5164);
let _e5169 = ((_e5147 - (_e5165 * 0.6933594f)) - (_e5165 * -2.1219444e-4f));
let _e5191 = -((_e5138.member_1 * _e5135));
let _e5193 = select(-87f, _e5191, (_e5191 > -87f));
let _e5195 = select(88f, _e5193, (_e5193 < 88f));
let _e5197 = ((_e5195 * 1.442695f) + 0.5f);
let _e5199 = select(-127f, _e5197, (_e5197 > -127f));
let _e5201 = select(128f, _e5199, (_e5199 < 128f));
let _e5208 = select(0i, select(select(i32(_e5201), i32(-2147483648), (_e5201 < -2147483600f)), 2147483647i, (_e5201 > 2147483500f)), (_e5201 == _e5201));
let _e5212 = (_e5208 - select(0i, 1i, (_e5201 < f32(_e5208))));
let _e5213 = f32(_e5212);
let _e5217 = ((_e5195 - (_e5213 * 0.6933594f)) - (_e5213 * -2.1219444e-4f));
let _e5239 = -((_e5138.member_2 * _e5135));
let _e5241 = select(-87f, _e5239, (_e5239 > -87f));
let _e5243 = select(88f, _e5241, (_e5241 < 88f));
let _e5245 = ((_e5243 * 1.442695f) + 0.5f);
let _e5247 = select(-127f, _e5245, (_e5245 > -127f));
let _e5249 = select(128f, _e5247, (_e5247 < 128f));
let _e5256 = select(0i, select(select(i32(_e5249), i32(-2147483648), (_e5249 < -2147483600f)), 2147483647i, (_e5249 > 2147483500f)), (_e5249 == _e5249));
let _e5260 = (_e5256 - select(0i, 1i, (_e5249 < f32(_e5256))));
let _e5261 = f32(_e5260);
let _e5265 = ((_e5243 - (_e5261 * 0.6933594f)) - (_e5261 * -2.1219444e-4f));
let _e5288 = global_1.member.member_13.member_1;
let _e5301 = select(0f, _e5040, (((_e5043 >= 0f) && (_e5043 < _e725)) && (_e5040 > 0f)));
let _e5303 = ((_e800 + _e1962) + _e1966);
let _e5304 = (_e5303 & 31u);
let _e5306 = (1u << bitcast<u32>(_e5304));
let _e5315 = bitcast<i32>((((_e962 + _e5306) - 1u) >> bitcast<u32>(_e5304)));
let _e5316 = bitcast<i32>((((_e965 + _e5306) - 1u) >> bitcast<u32>(_e5304)));
if _e487 {
phi_82562_ = type_26(_e5316, _e5315);
} else {
phi_82562_ = type_26(_e5315, _e5316);
}
let _e5320 = phi_82562_;
let _e5325 = f32((1i << bitcast<u32>(_e5304)));
let _e5326 = (1f / _e5325);
let _e5328 = ((_e4754 * _e5326) - 0.5f);
let _e5330 = ((_e4848 * _e5326) - 0.5f);
let _e5332 = select(-1f, _e5328, (_e5328 > -1f));
let _e5334 = select(1e6f, _e5332, (_e5332 < 1e6f));
let _e5341 = select(0i, select(select(i32(_e5334), i32(-2147483648), (_e5334 < -2147483600f)), 2147483647i, (_e5334 > 2147483500f)), (_e5334 == _e5334));
let _e5345 = (_e5341 - select(0i, 1i, (_e5334 < f32(_e5341))));
let _e5347 = select(-1f, _e5330, (_e5330 > -1f));
let _e5349 = select(1e6f, _e5347, (_e5347 < 1e6f));
let _e5356 = select(0i, select(select(i32(_e5349), i32(-2147483648), (_e5349 < -2147483600f)), 2147483647i, (_e5349 > 2147483500f)), (_e5349 == _e5349));
let _e5360 = (_e5356 - select(0i, 1i, (_e5349 < f32(_e5356))));
let _e5362 = (_e5328 - f32(_e5345));
let _e5364 = (_e5330 - f32(_e5360));
let _e5365 = (1f - _e5362);
let _e5366 = (1f - _e5364);
let _e5369 = select(_e5345, 0i, (_e5345 < 0i));
let _e5370 = (_e5369 >= _e5320.member);
if _e5370 {
phi_82640_ = (_e5320.member - 1i);
} else {
phi_82640_ = _e5369;
}
let _e5373 = phi_82640_;
let _e5375 = select(_e5360, 0i, (_e5360 < 0i));
let _e5376 = (_e5375 >= _e5320.member_1);
if _e5376 {
phi_82651_ = (_e5320.member_1 - 1i);
} else {
phi_82651_ = _e5375;
}
let _e5379 = phi_82651_;
let _e5383 = (((f32(_e5373) + 0.5f) * _e5325) - 0.5f);
let _e5387 = (((f32(_e5379) + 0.5f) * _e5325) - 0.5f);
if _e487 {
phi_82679_ = type_26(_e5379, _e5373);
} else {
phi_82679_ = type_26(_e5373, _e5379);
}
let _e5393 = phi_82679_;
let _e5399 = bitcast<i32>(((_e962 + 1u) >> bitcast<u32>(1u)));
let _e5402 = global_1.member.member_18.member_6;
let _e5405 = global_1.member.member_18.member_7;
let _e5408 = global_1.member.member_18.member_8;
let _e5409 = (_e5303 == 0u);
if _e5409 {
phi_82730_ = 0u;
} else {
if (_e5303 == 1u) {
phi_82729_ = 0u;
} else {
if (_e5303 == 2u) {
phi_82728_ = _e5402;
} else {
phi_82728_ = select(_e5408, _e5405, (_e5303 == 3u));
}
let _e5415 = phi_82728_;
phi_82729_ = _e5415;
}
let _e5417 = phi_82729_;
phi_82730_ = _e5417;
}
let _e5419 = phi_82730_;
local_32 = (((bitcast<i32>(_e5419) + _e5393.member_1) * _e5399) + _e5393.member);
let _e5424 = local_32;
let _e5426 = (bitcast<i32>(_e296) - 1i);
let _e5428 = select(_e5426, _e5424, (_e5424 < _e5426));
let _e5433 = global_6.member[bitcast<u32>(select(0i, _e5428, (_e5428 > 0i)))];
let _e5438 = (((((select(_e5383, _e5387, _e487) + 0.5f) / _e4928) * 2f) - 1f) * _e4936);
let _e5443 = ((1f - (((select(_e5387, _e5383, _e487) + 0.5f) / _e4929) * 2f)) * _e4944);
let _e5450 = ((_e4947.member * _e5438) + (_e4955.member * _e5443));
let _e5451 = ((_e4947.member_1 * _e5438) + (_e4955.member_1 * _e5443));
let _e5452 = ((_e4947.member_2 * _e5438) + (_e4955.member_2 * _e5443));
let _e5456 = select((_e4970.member + _e5450), _e4970.member, _e4968);
let _e5457 = select((_e4970.member_1 + _e5451), _e4970.member_1, _e4968);
let _e5458 = select((_e4970.member_2 + _e5452), _e4970.member_2, _e4968);
let _e5469 = (((_e5456 * _e5456) + (_e5457 * _e5457)) + (_e5458 * _e5458));
let _e5473 = (1f / sqrt(select(0f, _e5469, (_e5469 > 0f))));
let _e5474 = (_e5456 * _e5473);
let _e5475 = (_e5457 * _e5473);
let _e5476 = (_e5458 * _e5473);
let _e5477 = (_e609 - select(_e4981.member, (_e4981.member + _e5450), _e4968));
let _e5478 = (_e621 - select(_e4981.member_1, (_e4981.member_1 + _e5451), _e4968));
let _e5479 = (_e634 - select(_e4981.member_2, (_e4981.member_2 + _e5452), _e4968));
let _e5484 = (((_e5477 * _e5474) + (_e5478 * _e5475)) + (_e5479 * _e5476));
let _e5489 = (((_e5477 * _e647) + (_e5478 * _e660)) + (_e5479 * _e673));
let _e5494 = (((_e5474 * _e647) + (_e5475 * _e660)) + (_e5476 * _e673));
let _e5497 = ((_e5475 * _e673) - (_e5476 * _e660));
let _e5500 = ((_e5476 * _e647) - (_e5474 * _e673));
let _e5503 = ((_e5474 * _e660) - (_e5475 * _e647));
let _e5508 = (((_e5497 * _e5497) + (_e5500 * _e5500)) + (_e5503 * _e5503));
let _e5511 = (1f / select(1e-9f, _e5508, (_e5508 > 1e-9f)));
let _e5514 = ((_e5484 - (_e5494 * _e5489)) * _e5511);
let _e5517 = (((_e5494 * _e5484) - _e5489) * _e5511);
let _e5523 = select(0f, _e5514, (((_e5517 >= 0f) && (_e5517 < _e725)) && (_e5514 > 0f)));
let _e5525 = (_e5373 << bitcast<u32>(_e5304));
let _e5537 = (_e5345 + 1i);
let _e5540 = select(_e5537, 0i, (_e5537 < 0i));
let _e5541 = (_e5540 >= _e5320.member);
if _e5541 {
phi_83714_ = (_e5320.member - 1i);
} else {
phi_83714_ = _e5540;
}
let _e5544 = phi_83714_;
if _e5376 {
phi_83725_ = (_e5320.member_1 - 1i);
} else {
phi_83725_ = _e5375;
}
let _e5547 = phi_83725_;
let _e5551 = (((f32(_e5544) + 0.5f) * _e5325) - 0.5f);
let _e5555 = (((f32(_e5547) + 0.5f) * _e5325) - 0.5f);
if _e487 {
phi_83753_ = type_26(_e5547, _e5544);
} else {
phi_83753_ = type_26(_e5544, _e5547);
}
let _e5561 = phi_83753_;
if _e5409 {
phi_83804_ = 0u;
} else {
if (_e5303 == 1u) {
phi_83803_ = 0u;
} else {
if (_e5303 == 2u) {
phi_83802_ = _e5402;
} else {
phi_83802_ = select(_e5408, _e5405, (_e5303 == 3u));
}
let _e5569 = phi_83802_;
phi_83803_ = _e5569;
}
let _e5571 = phi_83803_;
phi_83804_ = _e5571;
}
let _e5573 = phi_83804_;
local_30 = (((bitcast<i32>(_e5573) + _e5561.member_1) * _e5399) + _e5561.member);
let _e5578 = local_30;
let _e5580 = select(_e5426, _e5578, (_e5578 < _e5426));
let _e5585 = global_6.member[bitcast<u32>(select(0i, _e5580, (_e5580 > 0i)))];
let _e5590 = (((((select(_e5551, _e5555, _e487) + 0.5f) / _e4928) * 2f) - 1f) * _e4936);
let _e5595 = ((1f - (((select(_e5555, _e5551, _e487) + 0.5f) / _e4929) * 2f)) * _e4944);
let _e5602 = ((_e4947.member * _e5590) + (_e4955.member * _e5595));
let _e5603 = ((_e4947.member_1 * _e5590) + (_e4955.member_1 * _e5595));
let _e5604 = ((_e4947.member_2 * _e5590) + (_e4955.member_2 * _e5595));
let _e5608 = select((_e4970.member + _e5602), _e4970.member, _e4968);
let _e5609 = select((_e4970.member_1 + _e5603), _e4970.member_1, _e4968);
let _e5610 = select((_e4970.member_2 + _e5604), _e4970.member_2, _e4968);
let _e5621 = (((_e5608 * _e5608) + (_e5609 * _e5609)) + (_e5610 * _e5610));
let _e5625 = (1f / sqrt(select(0f, _e5621, (_e5621 > 0f))));
let _e5626 = (_e5608 * _e5625);
let _e5627 = (_e5609 * _e5625);
let _e5628 = (_e5610 * _e5625);
let _e5629 = (_e609 - select(_e4981.member, (_e4981.member + _e5602), _e4968));
let _e5630 = (_e621 - select(_e4981.member_1, (_e4981.member_1 + _e5603), _e4968));
let _e5631 = (_e634 - select(_e4981.member_2, (_e4981.member_2 + _e5604), _e4968));
let _e5636 = (((_e5629 * _e5626) + (_e5630 * _e5627)) + (_e5631 * _e5628));
let _e5641 = (((_e5629 * _e647) + (_e5630 * _e660)) + (_e5631 * _e673));
let _e5646 = (((_e5626 * _e647) + (_e5627 * _e660)) + (_e5628 * _e673));
let _e5649 = ((_e5627 * _e673) - (_e5628 * _e660));
let _e5652 = ((_e5628 * _e647) - (_e5626 * _e673));
let _e5655 = ((_e5626 * _e660) - (_e5627 * _e647));
let _e5660 = (((_e5649 * _e5649) + (_e5652 * _e5652)) + (_e5655 * _e5655));
let _e5663 = (1f / select(1e-9f, _e5660, (_e5660 > 1e-9f)));
let _e5666 = ((_e5636 - (_e5646 * _e5641)) * _e5663);
let _e5669 = (((_e5646 * _e5636) - _e5641) * _e5663);
let _e5675 = select(0f, _e5666, (((_e5669 >= 0f) && (_e5669 < _e725)) && (_e5666 > 0f)));
let _e5677 = (_e5544 << bitcast<u32>(_e5304));
let _e5689 = (_e5360 + 1i);
if _e5370 {
phi_84788_ = (_e5320.member - 1i);
} else {
phi_84788_ = _e5369;
}
let _e5693 = phi_84788_;
let _e5695 = select(_e5689, 0i, (_e5689 < 0i));
let _e5696 = (_e5695 >= _e5320.member_1);
if _e5696 {
phi_84799_ = (_e5320.member_1 - 1i);
} else {
phi_84799_ = _e5695;
}
let _e5699 = phi_84799_;
let _e5703 = (((f32(_e5693) + 0.5f) * _e5325) - 0.5f);
let _e5707 = (((f32(_e5699) + 0.5f) * _e5325) - 0.5f);
if _e487 {
phi_84827_ = type_26(_e5699, _e5693);
} else {
phi_84827_ = type_26(_e5693, _e5699);
}
let _e5713 = phi_84827_;
if _e5409 {
phi_84878_ = 0u;
} else {
if (_e5303 == 1u) {
phi_84877_ = 0u;
} else {
if (_e5303 == 2u) {
phi_84876_ = _e5402;
} else {
phi_84876_ = select(_e5408, _e5405, (_e5303 == 3u));
}
let _e5721 = phi_84876_;
phi_84877_ = _e5721;
}
let _e5723 = phi_84877_;
phi_84878_ = _e5723;
}
let _e5725 = phi_84878_;
local_28 = (((bitcast<i32>(_e5725) + _e5713.member_1) * _e5399) + _e5713.member);
let _e5730 = local_28;
let _e5732 = select(_e5426, _e5730, (_e5730 < _e5426));
let _e5737 = global_6.member[bitcast<u32>(select(0i, _e5732, (_e5732 > 0i)))];
let _e5742 = (((((select(_e5703, _e5707, _e487) + 0.5f) / _e4928) * 2f) - 1f) * _e4936);
let _e5747 = ((1f - (((select(_e5707, _e5703, _e487) + 0.5f) / _e4929) * 2f)) * _e4944);
let _e5754 = ((_e4947.member * _e5742) + (_e4955.member * _e5747));
let _e5755 = ((_e4947.member_1 * _e5742) + (_e4955.member_1 * _e5747));
let _e5756 = ((_e4947.member_2 * _e5742) + (_e4955.member_2 * _e5747));
let _e5760 = select((_e4970.member + _e5754), _e4970.member, _e4968);
let _e5761 = select((_e4970.member_1 + _e5755), _e4970.member_1, _e4968);
let _e5762 = select((_e4970.member_2 + _e5756), _e4970.member_2, _e4968);
let _e5773 = (((_e5760 * _e5760) + (_e5761 * _e5761)) + (_e5762 * _e5762));
let _e5777 = (1f / sqrt(select(0f, _e5773, (_e5773 > 0f))));
let _e5778 = (_e5760 * _e5777);
let _e5779 = (_e5761 * _e5777);
let _e5780 = (_e5762 * _e5777);
let _e5781 = (_e609 - select(_e4981.member, (_e4981.member + _e5754), _e4968));
let _e5782 = (_e621 - select(_e4981.member_1, (_e4981.member_1 + _e5755), _e4968));
let _e5783 = (_e634 - select(_e4981.member_2, (_e4981.member_2 + _e5756), _e4968));
let _e5788 = (((_e5781 * _e5778) + (_e5782 * _e5779)) + (_e5783 * _e5780));
let _e5793 = (((_e5781 * _e647) + (_e5782 * _e660)) + (_e5783 * _e673));
let _e5798 = (((_e5778 * _e647) + (_e5779 * _e660)) + (_e5780 * _e673));
let _e5801 = ((_e5779 * _e673) - (_e5780 * _e660));
let _e5804 = ((_e5780 * _e647) - (_e5778 * _e673));
let _e5807 = ((_e5778 * _e660) - (_e5779 * _e647));
let _e5812 = (((_e5801 * _e5801) + (_e5804 * _e5804)) + (_e5807 * _e5807));
let _e5815 = (1f / select(1e-9f, _e5812, (_e5812 > 1e-9f)));
let _e5818 = ((_e5788 - (_e5798 * _e5793)) * _e5815);
let _e5821 = (((_e5798 * _e5788) - _e5793) * _e5815);
let _e5827 = select(0f, _e5818, (((_e5821 >= 0f) && (_e5821 < _e725)) && (_e5818 > 0f)));
let _e5829 = (_e5693 << bitcast<u32>(_e5304));
if _e5541 {
phi_85862_ = (_e5320.member - 1i);
} else {
phi_85862_ = _e5540;
}
let _e5844 = phi_85862_;
if _e5696 {
phi_85873_ = (_e5320.member_1 - 1i);
} else {
phi_85873_ = _e5695;
}
let _e5847 = phi_85873_;
let _e5851 = (((f32(_e5844) + 0.5f) * _e5325) - 0.5f);
let _e5855 = (((f32(_e5847) + 0.5f) * _e5325) - 0.5f);
if _e487 {
phi_85901_ = type_26(_e5847, _e5844);
} else {
phi_85901_ = type_26(_e5844, _e5847);
}
let _e5861 = phi_85901_;
if _e5409 {
phi_85952_ = 0u;
} else {
if (_e5303 == 1u) {
phi_85951_ = 0u;
} else {
if (_e5303 == 2u) {
phi_85950_ = _e5402;
} else {
phi_85950_ = select(_e5408, _e5405, (_e5303 == 3u));
}
let _e5869 = phi_85950_;
phi_85951_ = _e5869;
}
let _e5871 = phi_85951_;
phi_85952_ = _e5871;
}
let _e5873 = phi_85952_;
local_26 = (((bitcast<i32>(_e5873) + _e5861.member_1) * _e5399) + _e5861.member);
let _e5878 = local_26;
let _e5880 = select(_e5426, _e5878, (_e5878 < _e5426));
let _e5885 = global_6.member[bitcast<u32>(select(0i, _e5880, (_e5880 > 0i)))];
let _e5890 = (((((select(_e5851, _e5855, _e487) + 0.5f) / _e4928) * 2f) - 1f) * _e4936);
let _e5895 = ((1f - (((select(_e5855, _e5851, _e487) + 0.5f) / _e4929) * 2f)) * _e4944);
let _e5902 = ((_e4947.member * _e5890) + (_e4955.member * _e5895));
let _e5903 = ((_e4947.member_1 * _e5890) + (_e4955.member_1 * _e5895));
let _e5904 = ((_e4947.member_2 * _e5890) + (_e4955.member_2 * _e5895));
let _e5908 = select((_e4970.member + _e5902), _e4970.member, _e4968);
let _e5909 = select((_e4970.member_1 + _e5903), _e4970.member_1, _e4968);
let _e5910 = select((_e4970.member_2 + _e5904), _e4970.member_2, _e4968);
let _e5921 = (((_e5908 * _e5908) + (_e5909 * _e5909)) + (_e5910 * _e5910));
let _e5925 = (1f / sqrt(select(0f, _e5921, (_e5921 > 0f))));
let _e5926 = (_e5908 * _e5925);
let _e5927 = (_e5909 * _e5925);
let _e5928 = (_e5910 * _e5925);
let _e5929 = (_e609 - select(_e4981.member, (_e4981.member + _e5902), _e4968));
let _e5930 = (_e621 - select(_e4981.member_1, (_e4981.member_1 + _e5903), _e4968));
let _e5931 = (_e634 - select(_e4981.member_2, (_e4981.member_2 + _e5904), _e4968));
let _e5936 = (((_e5929 * _e5926) + (_e5930 * _e5927)) + (_e5931 * _e5928));
let _e5941 = (((_e5929 * _e647) + (_e5930 * _e660)) + (_e5931 * _e673));
let _e5946 = (((_e5926 * _e647) + (_e5927 * _e660)) + (_e5928 * _e673));
let _e5949 = ((_e5927 * _e673) - (_e5928 * _e660));
let _e5952 = ((_e5928 * _e647) - (_e5926 * _e673));
let _e5955 = ((_e5926 * _e660) - (_e5927 * _e647));
let _e5960 = (((_e5949 * _e5949) + (_e5952 * _e5952)) + (_e5955 * _e5955));
let _e5963 = (1f / select(1e-9f, _e5960, (_e5960 > 1e-9f)));
let _e5966 = ((_e5936 - (_e5946 * _e5941)) * _e5963);
let _e5969 = (((_e5946 * _e5936) - _e5941) * _e5963);
let _e5975 = select(0f, _e5966, (((_e5969 >= 0f) && (_e5969 < _e725)) && (_e5966 > 0f)));
let _e5977 = (_e5844 << bitcast<u32>(_e5304));
let _e5989 = select(((((1f - select(0f, (_e5365 * _e5366), (((select(select(_e800, _e957, (_e5525 >= _e726)), _e879, (_e5525 < _e332)) == _e5303) && (_e5523 > 0f)) && (_e5523 < _e5433)))) - select(0f, (_e5362 * _e5366), (((select(select(_e800, _e957, (_e5677 >= _e726)), _e879, (_e5677 < _e332)) == _e5303) && (_e5675 > 0f)) && (_e5675 < _e5585)))) - select(0f, (_e5365 * _e5364), (((select(select(_e800, _e957, (_e5829 >= _e726)), _e879, (_e5829 < _e332)) == _e5303) && (_e5827 > 0f)) && (_e5827 < _e5737)))) - select(0f, (_e5362 * _e5364), (((select(select(_e800, _e957, (_e5977 >= _e726)), _e879, (_e5977 < _e332)) == _e5303) && (_e5975 > 0f)) && (_e5975 < _e5885)))), 1f, _e5409);
if _e487 {
phi_86945_ = type_26(_e4845, _e4752);
} else {
phi_86945_ = type_26(_e4752, _e4845);
}
let _e6004 = phi_86945_;
let _e6007 = (_e4846 && (((_e5301 > 0f) && (_e5301 < _e4925)) && (bitcast<f32>((bitcast<u32>(_e5989) & 2147483647u)) > 1e-6f)));
let _e6010 = global_1.member.member_18.member;
let _e6011 = (((select(_e4871, (1f - _e4871), (_e4856 >= 0f)) - select(_e4890, (1f - _e4890), (_e4875 >= 0f))) * (1f / _e4853)) * _e6010);
let _e6015 = select(0f, (((((_e686 * _e5288.member) * ((1f + (_e5169 * (1f + (_e5169 * (0.5f + (_e5169 * (0.16666667f + (_e5169 * (0.041666668f + (_e5169 * (0.008333334f + (_e5169 * (0.001388889f + (_e5169 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5164 + 127i)) << bitcast<u32>(23i))))) * _e5131) * _e5989) * _e6011), _e6007);
let _e6016 = select(0f, (((((_e699 * _e5288.member_1) * ((1f + (_e5217 * (1f + (_e5217 * (0.5f + (_e5217 * (0.16666667f + (_e5217 * (0.041666668f + (_e5217 * (0.008333334f + (_e5217 * (0.001388889f + (_e5217 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5212 + 127i)) << bitcast<u32>(23i))))) * _e5131) * _e5989) * _e6011), _e6007);
let _e6017 = select(0f, (((((_e712 * _e5288.member_2) * ((1f + (_e5265 * (1f + (_e5265 * (0.5f + (_e5265 * (0.16666667f + (_e5265 * (0.041666668f + (_e5265 * (0.008333334f + (_e5265 * (0.001388889f + (_e5265 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5260 + 127i)) << bitcast<u32>(23i))))) * _e5131) * _e5989) * _e6011), _e6007);
let _e6021 = (bitcast<f32>((bitcast<u32>(_e6015) & 2147483647u)) >= 1073741800f);
let _e6022 = (1f / 1048576f);
let _e6025 = ((_e6015 * select(1f, _e6022, _e6021)) + 0.5f);
let _e6027 = select(-1073741800f, _e6025, (_e6025 > -1073741800f));
let _e6029 = select(1073741800f, _e6027, (_e6027 < 1073741800f));
let _e6036 = select(0i, select(select(i32(_e6029), i32(-2147483648), (_e6029 < -2147483600f)), 2147483647i, (_e6029 > 2147483500f)), (_e6029 == _e6029));
let _e6040 = (_e6036 - select(0i, 1i, (_e6029 < f32(_e6036))));
let _e6041 = select(0i, 20i, _e6021);
let _e6045 = (bitcast<u32>(_e6040) << bitcast<u32>((_e6041 & 31i)));
let _e6052 = bitcast<u32>(((_e6040 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e6041) & 31i))));
let _e6056 = (bitcast<f32>((bitcast<u32>(_e6016) & 2147483647u)) >= 1073741800f);
let _e6059 = ((_e6016 * select(1f, _e6022, _e6056)) + 0.5f);
let _e6061 = select(-1073741800f, _e6059, (_e6059 > -1073741800f));
let _e6063 = select(1073741800f, _e6061, (_e6061 < 1073741800f));
let _e6070 = select(0i, select(select(i32(_e6063), i32(-2147483648), (_e6063 < -2147483600f)), 2147483647i, (_e6063 > 2147483500f)), (_e6063 == _e6063));
let _e6074 = (_e6070 - select(0i, 1i, (_e6063 < f32(_e6070))));
let _e6075 = select(0i, 20i, _e6056);
let _e6079 = (bitcast<u32>(_e6074) << bitcast<u32>((_e6075 & 31i)));
let _e6086 = bitcast<u32>(((_e6074 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e6075) & 31i))));
let _e6090 = (bitcast<f32>((bitcast<u32>(_e6017) & 2147483647u)) >= 1073741800f);
let _e6093 = ((_e6017 * select(1f, _e6022, _e6090)) + 0.5f);
let _e6095 = select(-1073741800f, _e6093, (_e6093 > -1073741800f));
let _e6097 = select(1073741800f, _e6095, (_e6095 < 1073741800f));
let _e6104 = select(0i, select(select(i32(_e6097), i32(-2147483648), (_e6097 < -2147483600f)), 2147483647i, (_e6097 > 2147483500f)), (_e6097 == _e6097));
let _e6108 = (_e6104 - select(0i, 1i, (_e6097 < f32(_e6104))));
let _e6109 = select(0i, 20i, _e6090);
let _e6113 = (bitcast<u32>(_e6108) << bitcast<u32>((_e6109 & 31i)));
let _e6120 = bitcast<u32>(((_e6108 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e6109) & 31i))));
let _e6125 = bitcast<i32>(bitcast<u32>((((_e6004.member_1 * _e966) + _e6004.member) * 6i)));
if ((_e6045 | _e6052) == 0u) {
} else {
let _e6128 = bitcast<u32>(_e6125);
if (_e6128 < _e304) {
let _e6132 = atomicAdd((&global_8.member[_e6128]), _e6045);
phi_87178_ = _e6132;
} else {
phi_87178_ = 0u;
}
let _e6134 = phi_87178_;
let _e6138 = (_e6052 + select(0u, 1u, ((_e6134 + _e6045) < _e6045)));
if (_e6138 == 0u) {
} else {
let _e6140 = (_e6128 + 1u);
if (_e6140 < _e304) {
let _e6144 = atomicAdd((&global_8.member[_e6140]), _e6138);
}
}
}
if ((_e6079 | _e6086) == 0u) {
} else {
let _e6148 = bitcast<u32>((_e6125 + 2i));
if (_e6148 < _e304) {
let _e6152 = atomicAdd((&global_8.member[_e6148]), _e6079);
phi_87208_ = _e6152;
} else {
phi_87208_ = 0u;
}
let _e6154 = phi_87208_;
let _e6158 = (_e6086 + select(0u, 1u, ((_e6154 + _e6079) < _e6079)));
if (_e6158 == 0u) {
} else {
let _e6160 = (_e6148 + 1u);
if (_e6160 < _e304) {
let _e6164 = atomicAdd((&global_8.member[_e6160]), _e6158);
}
}
}
if ((_e6113 | _e6120) == 0u) {
} else {
let _e6168 = bitcast<u32>((_e6125 + 4i));
if (_e6168 < _e304) {
let _e6172 = atomicAdd((&global_8.member[_e6168]), _e6113);
phi_87238_ = _e6172;
} else {
phi_87238_ = 0u;
}
let _e6174 = phi_87238_;
let _e6178 = (_e6120 + select(0u, 1u, ((_e6174 + _e6113) < _e6113)));
if (_e6178 == 0u) {
} else {
let _e6180 = (_e6168 + 1u);
if (_e6180 < _e304) {
let _e6184 = atomicAdd((&global_8.member[_e6180]), _e6178);
}
}
}
phi_81403_ = (_e4843 + 1i);
} else {
phi_81403_ = i32();
}
let _e6187 = phi_81403_;
continue;
continuing {
phi_81402_ = _e6187;
break if !(_e4846);
}
}
phi_81249_ = (_e4749 + 1i);
} else {
phi_81249_ = i32();
}
let _e6191 = phi_81249_;
continue;
continuing {
phi_81248_ = _e6191;
break if !(_e4750);
}
}
} else {
phi_87283_ = 0i;
loop {
let _e1978 = phi_87283_;
let _e1979 = (_e1978 < 16i);
if _e1979 {
let _e1981 = (_e1011 + (_e1978 & 15i));
let _e1983 = (f32(_e1981) + 0.5f);
let _e1985 = ((_e1983 * 1f) - 0.5f);
let _e1989 = (-(((_e450 * _e1985) + _e476)) / _e463);
let _e1996 = bitcast<f32>((bitcast<u32>(((_e500 * _e1985) + ((_e513 * _e1989) + _e526))) & 2147483647u));
let _e2003 = bitcast<f32>((bitcast<u32>(((_e539 * _e1985) + ((_e552 * _e1989) + _e565))) & 2147483647u));
let _e2007 = (((0.5f * (_e1996 + _e2003)) / _e568) + _e751);
let _e2008 = (1f / 1f);
let _e2016 = ((((_e1989 + _e2007) + 0.5f) * _e2008) - 0.5f);
let _e2017 = f32(_e1960);
let _e2018 = f32(_e1958);
let _e2019 = (_e2017 - 1f);
let _e2021 = select(_e2019, _e2016, (_e2016 > _e2019));
let _e2023 = select(_e2018, _e2021, (_e2021 < _e2018));
let _e2030 = select(0i, select(select(i32(_e2023), i32(-2147483648), (_e2023 < -2147483600f)), 2147483647i, (_e2023 > 2147483500f)), (_e2023 == _e2023));
let _e2035 = (((((_e1989 - _e2007) + 0.5f) * _e2008) - 0.5f) + 1f);
let _e2036 = (_e2018 + 1f);
let _e2038 = select(_e2017, _e2035, (_e2035 > _e2017));
let _e2040 = select(_e2036, _e2038, (_e2038 < _e2036));
let _e2047 = select(0i, select(select(i32(_e2040), i32(-2147483648), (_e2040 < -2147483600f)), 2147483647i, (_e2040 > 2147483500f)), (_e2040 == _e2040));
let _e2058 = ((1e-4f * 1f) * _e568);
let _e2060 = select(_e2003, _e1996, (_e1996 > _e2003));
let _e2062 = select(_e2058, _e2060, (_e2060 > _e2058));
let _e2064 = select(_e2003, _e1996, (_e1996 < _e2003));
let _e2066 = select(_e2058, _e2064, (_e2064 > _e2058));
let _e2068 = (0.5f * (_e2062 + _e2066));
let _e2069 = (0.5f / _e2066);
let _e2070 = (1f / _e2062);
phi_87437_ = 0i;
loop {
let _e2072 = phi_87437_;
let _e2074 = (((_e2047 - select(0i, 1i, (_e2040 < f32(_e2047)))) + (_e1978 >> bitcast<u32>(4u))) + bitcast<i32>(_e2072));
let _e2075 = (_e2074 <= select(-1i, (_e2030 - select(0i, 1i, (_e2023 < f32(_e2030)))), (_e1981 <= _e1015)));
if _e2075 {
let _e2077 = (f32(_e2074) + 0.5f);
let _e2081 = ((((_e2077 * 1f) - 0.5f) - _e1989) * _e568);
let _e2082 = (_e568 * 1f);
let _e2084 = (0.5f * _e2082);
let _e2085 = (_e2081 + _e2084);
let _e2086 = -(_e2085);
let _e2089 = (_e2068 - select(_e2086, _e2085, (_e2085 > _e2086)));
let _e2091 = select(0f, _e2089, (_e2089 > 0f));
let _e2093 = select(_e2066, _e2091, (_e2091 < _e2066));
let _e2096 = (_e2089 - _e2066);
let _e2100 = (((_e2093 * (_e2093 * _e2069)) + select(0f, _e2096, (_e2096 > 0f))) * _e2070);
let _e2104 = (_e2081 - _e2084);
let _e2105 = -(_e2104);
let _e2108 = (_e2068 - select(_e2105, _e2104, (_e2104 > _e2105)));
let _e2110 = select(0f, _e2108, (_e2108 > 0f));
let _e2112 = select(_e2066, _e2110, (_e2110 < _e2066));
let _e2115 = (_e2108 - _e2066);
let _e2119 = (((_e2112 * (_e2112 * _e2069)) + select(0f, _e2115, (_e2115 > 0f))) * _e2070);
if _e487 {
phi_87542_ = type_26(_e2074, _e1981);
} else {
phi_87542_ = type_26(_e1981, _e2074);
}
let _e2128 = phi_87542_;
local_24 = bitcast<i32>((_e962 * _e965));
local_25 = ((_e2128.member_1 * _e966) + _e2128.member);
let _e2135 = local_24;
let _e2136 = local_25;
let _e2137 = (_e2135 + _e2136);
let _e2139 = (bitcast<i32>(_e293) - 1i);
let _e2141 = select(_e2139, _e2137, (_e2137 < _e2139));
let _e2146 = global_5.member[bitcast<u32>(select(0i, _e2141, (_e2141 > 0i)))];
let _e2147 = local_25;
let _e2149 = select(_e2139, _e2147, (_e2147 < _e2139));
let _e2154 = global_5.member[bitcast<u32>(select(0i, _e2149, (_e2149 > 0i)))];
let _e2157 = f32(_e966);
let _e2158 = f32(_e967);
let _e2165 = global_1.member.member_2.member;
let _e2166 = (((((f32(_e2128.member) + 0.5f) / _e2157) * 2f) - 1f) * _e2165);
let _e2173 = global_1.member.member_2.member_1;
let _e2174 = ((1f - (((f32(_e2128.member_1) + 0.5f) / _e2158) * 2f)) * _e2173);
let _e2176 = global_1.member.member_3;
let _e2184 = global_1.member.member_4;
let _e2191 = ((_e2176.member * _e2166) + (_e2184.member * _e2174));
let _e2192 = ((_e2176.member_1 * _e2166) + (_e2184.member_1 * _e2174));
let _e2193 = ((_e2176.member_2 * _e2166) + (_e2184.member_2 * _e2174));
let _e2196 = global_1.member.member_2.member_3;
let _e2197 = (_e2196 != 0u);
let _e2199 = global_1.member.member_5;
let _e2206 = select((_e2199.member + _e2191), _e2199.member, _e2197);
let _e2207 = select((_e2199.member_1 + _e2192), _e2199.member_1, _e2197);
let _e2208 = select((_e2199.member_2 + _e2193), _e2199.member_2, _e2197);
let _e2210 = global_1.member.member_6;
let _e2224 = (((_e2206 * _e2206) + (_e2207 * _e2207)) + (_e2208 * _e2208));
let _e2227 = sqrt(select(0f, _e2224, (_e2224 > 0f)));
let _e2228 = (1f / _e2227);
let _e2229 = (_e2206 * _e2228);
let _e2230 = (_e2207 * _e2228);
let _e2231 = (_e2208 * _e2228);
let _e2232 = (_e609 - select(_e2210.member, (_e2210.member + _e2191), _e2197));
let _e2233 = (_e621 - select(_e2210.member_1, (_e2210.member_1 + _e2192), _e2197));
let _e2234 = (_e634 - select(_e2210.member_2, (_e2210.member_2 + _e2193), _e2197));
let _e2239 = (((_e2232 * _e2229) + (_e2233 * _e2230)) + (_e2234 * _e2231));
let _e2244 = (((_e2232 * _e647) + (_e2233 * _e660)) + (_e2234 * _e673));
let _e2249 = (((_e2229 * _e647) + (_e2230 * _e660)) + (_e2231 * _e673));
let _e2252 = ((_e2230 * _e673) - (_e2231 * _e660));
let _e2255 = ((_e2231 * _e647) - (_e2229 * _e673));
let _e2258 = ((_e2229 * _e660) - (_e2230 * _e647));
let _e2263 = (((_e2252 * _e2252) + (_e2255 * _e2255)) + (_e2258 * _e2258));
let _e2266 = (1f / select(1e-9f, _e2263, (_e2263 > 1e-9f)));
let _e2269 = ((_e2239 - (_e2249 * _e2244)) * _e2266);
let _e2272 = (((_e2249 * _e2239) - _e2244) * _e2266);
let _e2278 = -(_e2249);
let _e2281 = global_1.member.member_13.member_2;
let _e2282 = (_e2281 * _e2281);
let _e2286 = ((1f + _e2282) - ((2f * _e2281) * _e2278));
let _e2288 = select(1e-9f, _e2286, (_e2286 > 1e-9f));
let _e2300 = global_1.member.member_13.member_3;
if (_e2300 == 2u) {
let _e2305 = (0.5f - (0.5f * _e2278));
let _e2307 = select(0f, _e2305, (_e2305 > 0f));
let _e2311 = (sqrt(select(0f, _e2307, (_e2307 > 0f))) * 255f);
let _e2312 = (255f - 1f);
let _e2314 = select(0f, _e2311, (_e2311 > 0f));
let _e2316 = select(_e2312, _e2314, (_e2314 < _e2312));
let _e2323 = select(0i, select(select(i32(_e2316), i32(-2147483648), (_e2316 < -2147483600f)), 2147483647i, (_e2316 > 2147483500f)), (_e2316 == _e2316));
let _e2327 = (_e2323 - select(0i, 1i, (_e2316 < f32(_e2323))));
let _e2330 = global_1.member.member_13.member_11;
let _e2331 = bitcast<i32>(_e2330);
let _e2332 = (_e2331 + _e2327);
let _e2334 = (bitcast<i32>(_e299) - 1i);
let _e2336 = select(_e2334, _e2332, (_e2332 < _e2334));
let _e2341 = global_2.member[bitcast<u32>(select(0i, _e2336, (_e2336 > 0i)))];
let _e2343 = (_e2331 + (_e2327 + 1i));
let _e2345 = select(_e2334, _e2343, (_e2343 < _e2334));
let _e2350 = global_2.member[bitcast<u32>(select(0i, _e2345, (_e2345 > 0i)))];
phi_87969_ = (_e2341 + ((_e2350 - _e2341) * (_e2311 - f32(_e2327))));
} else {
phi_87969_ = select(((1f - _e2282) / (_e2288 * sqrt(select(0f, _e2288, (_e2288 > 0f))))), (0.75f * (1f + (_e2278 * _e2278))), (_e2300 == 1u));
}
let _e2357 = phi_87969_;
let _e2360 = (_e2227 * (_e2357 * (0.25f / 3.1415927f)));
let _e2361 = (_e2269 - _e2146);
let _e2364 = (_e2272 + select(0f, _e2361, (_e2361 > 0f)));
let _e2367 = global_1.member.member_13.member;
let _e2372 = -((_e2367.member * _e2364));
let _e2374 = select(-87f, _e2372, (_e2372 > -87f));
let _e2376 = select(88f, _e2374, (_e2374 < 88f));
let _e2378 = ((_e2376 * 1.442695f) + 0.5f);
let _e2380 = select(-127f, _e2378, (_e2378 > -127f));
let _e2382 = select(128f, _e2380, (_e2380 < 128f));
let _e2389 = select(0i, select(select(i32(_e2382), i32(-2147483648), (_e2382 < -2147483600f)), 2147483647i, (_e2382 > 2147483500f)), (_e2382 == _e2382));
let _e2393 = (_e2389 - select(0i, 1i, (_e2382 < f32(_e2389))));
let _e2394 = f32(_e2393);
let _e2398 = ((_e2376 - (_e2394 * 0.6933594f)) - (_e2394 * -2.1219444e-4f));
let _e2420 = -((_e2367.member_1 * _e2364));
let _e2422 = select(-87f, _e2420, (_e2420 > -87f));
let _e2424 = select(88f, _e2422, (_e2422 < 88f));
let _e2426 = ((_e2424 * 1.442695f) + 0.5f);
let _e2428 = select(-127f, _e2426, (_e2426 > -127f));
let _e2430 = select(128f, _e2428, (_e2428 < 128f));
let _e2437 = select(0i, select(select(i32(_e2430), i32(-2147483648), (_e2430 < -2147483600f)), 2147483647i, (_e2430 > 2147483500f)), (_e2430 == _e2430));
let _e2441 = (_e2437 - select(0i, 1i, (_e2430 < f32(_e2437))));
let _e2442 = f32(_e2441);
let _e2446 = ((_e2424 - (_e2442 * 0.6933594f)) - (_e2442 * -2.1219444e-4f));
let _e2468 = -((_e2367.member_2 * _e2364));
let _e2470 = select(-87f, _e2468, (_e2468 > -87f));
let _e2472 = select(88f, _e2470, (_e2470 < 88f));
let _e2474 = ((_e2472 * 1.442695f) + 0.5f);
let _e2476 = select(-127f, _e2474, (_e2474 > -127f));
let _e2478 = select(128f, _e2476, (_e2476 < 128f));
let _e2485 = select(0i, select(select(i32(_e2478), i32(-2147483648), (_e2478 < -2147483600f)), 2147483647i, (_e2478 > 2147483500f)), (_e2478 == _e2478));
let _e2489 = (_e2485 - select(0i, 1i, (_e2478 < f32(_e2485))));
let _e2490 = f32(_e2489);
let _e2494 = ((_e2472 - (_e2490 * 0.6933594f)) - (_e2490 * -2.1219444e-4f));
let _e2517 = global_1.member.member_13.member_1;
let _e2530 = select(0f, _e2269, (((_e2272 >= 0f) && (_e2272 < _e725)) && (_e2269 > 0f)));
if _e487 {
phi_88595_ = type_26(_e1030, _e1029);
} else {
phi_88595_ = type_26(_e1029, _e1030);
}
let _e2534 = phi_88595_;
let _e2539 = f32((1i << bitcast<u32>(_e1018)));
let _e2540 = (1f / _e2539);
let _e2542 = ((_e1983 * _e2540) - 0.5f);
let _e2544 = ((_e2077 * _e2540) - 0.5f);
let _e2546 = select(-1f, _e2542, (_e2542 > -1f));
let _e2548 = select(1e6f, _e2546, (_e2546 < 1e6f));
let _e2555 = select(0i, select(select(i32(_e2548), i32(-2147483648), (_e2548 < -2147483600f)), 2147483647i, (_e2548 > 2147483500f)), (_e2548 == _e2548));
let _e2559 = (_e2555 - select(0i, 1i, (_e2548 < f32(_e2555))));
let _e2561 = select(-1f, _e2544, (_e2544 > -1f));
let _e2563 = select(1e6f, _e2561, (_e2561 < 1e6f));
let _e2570 = select(0i, select(select(i32(_e2563), i32(-2147483648), (_e2563 < -2147483600f)), 2147483647i, (_e2563 > 2147483500f)), (_e2563 == _e2563));
let _e2574 = (_e2570 - select(0i, 1i, (_e2563 < f32(_e2570))));
let _e2576 = (_e2542 - f32(_e2559));
let _e2578 = (_e2544 - f32(_e2574));
let _e2579 = (1f - _e2576);
let _e2580 = (1f - _e2578);
let _e2583 = select(_e2559, 0i, (_e2559 < 0i));
let _e2584 = (_e2583 >= _e2534.member);
if _e2584 {
phi_88673_ = (_e2534.member - 1i);
} else {
phi_88673_ = _e2583;
}
let _e2587 = phi_88673_;
let _e2589 = select(_e2574, 0i, (_e2574 < 0i));
let _e2590 = (_e2589 >= _e2534.member_1);
if _e2590 {
phi_88684_ = (_e2534.member_1 - 1i);
} else {
phi_88684_ = _e2589;
}
let _e2593 = phi_88684_;
let _e2597 = (((f32(_e2587) + 0.5f) * _e2539) - 0.5f);
let _e2601 = (((f32(_e2593) + 0.5f) * _e2539) - 0.5f);
if _e487 {
phi_88712_ = type_26(_e2593, _e2587);
} else {
phi_88712_ = type_26(_e2587, _e2593);
}
let _e2607 = phi_88712_;
let _e2613 = bitcast<i32>(((_e962 + 1u) >> bitcast<u32>(1u)));
let _e2616 = global_1.member.member_18.member_6;
let _e2619 = global_1.member.member_18.member_7;
let _e2622 = global_1.member.member_18.member_8;
if _e1017 {
phi_88763_ = 0u;
} else {
if (_e800 == 1u) {
phi_88762_ = 0u;
} else {
if (_e800 == 2u) {
phi_88761_ = _e2616;
} else {
phi_88761_ = select(_e2622, _e2619, (_e800 == 3u));
}
let _e2628 = phi_88761_;
phi_88762_ = _e2628;
}
let _e2630 = phi_88762_;
phi_88763_ = _e2630;
}
let _e2632 = phi_88763_;
local_22 = (((bitcast<i32>(_e2632) + _e2607.member_1) * _e2613) + _e2607.member);
let _e2637 = local_22;
let _e2639 = (bitcast<i32>(_e296) - 1i);
let _e2641 = select(_e2639, _e2637, (_e2637 < _e2639));
let _e2646 = global_6.member[bitcast<u32>(select(0i, _e2641, (_e2641 > 0i)))];
let _e2651 = (((((select(_e2597, _e2601, _e487) + 0.5f) / _e2157) * 2f) - 1f) * _e2165);
let _e2656 = ((1f - (((select(_e2601, _e2597, _e487) + 0.5f) / _e2158) * 2f)) * _e2173);
let _e2663 = ((_e2176.member * _e2651) + (_e2184.member * _e2656));
let _e2664 = ((_e2176.member_1 * _e2651) + (_e2184.member_1 * _e2656));
let _e2665 = ((_e2176.member_2 * _e2651) + (_e2184.member_2 * _e2656));
let _e2669 = select((_e2199.member + _e2663), _e2199.member, _e2197);
let _e2670 = select((_e2199.member_1 + _e2664), _e2199.member_1, _e2197);
let _e2671 = select((_e2199.member_2 + _e2665), _e2199.member_2, _e2197);
let _e2682 = (((_e2669 * _e2669) + (_e2670 * _e2670)) + (_e2671 * _e2671));
let _e2686 = (1f / sqrt(select(0f, _e2682, (_e2682 > 0f))));
let _e2687 = (_e2669 * _e2686);
let _e2688 = (_e2670 * _e2686);
let _e2689 = (_e2671 * _e2686);
let _e2690 = (_e609 - select(_e2210.member, (_e2210.member + _e2663), _e2197));
let _e2691 = (_e621 - select(_e2210.member_1, (_e2210.member_1 + _e2664), _e2197));
let _e2692 = (_e634 - select(_e2210.member_2, (_e2210.member_2 + _e2665), _e2197));
let _e2697 = (((_e2690 * _e2687) + (_e2691 * _e2688)) + (_e2692 * _e2689));
let _e2702 = (((_e2690 * _e647) + (_e2691 * _e660)) + (_e2692 * _e673));
let _e2707 = (((_e2687 * _e647) + (_e2688 * _e660)) + (_e2689 * _e673));
let _e2710 = ((_e2688 * _e673) - (_e2689 * _e660));
let _e2713 = ((_e2689 * _e647) - (_e2687 * _e673));
let _e2716 = ((_e2687 * _e660) - (_e2688 * _e647));
let _e2721 = (((_e2710 * _e2710) + (_e2713 * _e2713)) + (_e2716 * _e2716));
let _e2724 = (1f / select(1e-9f, _e2721, (_e2721 > 1e-9f)));
let _e2727 = ((_e2697 - (_e2707 * _e2702)) * _e2724);
let _e2730 = (((_e2707 * _e2697) - _e2702) * _e2724);
let _e2736 = select(0f, _e2727, (((_e2730 >= 0f) && (_e2730 < _e725)) && (_e2727 > 0f)));
let _e2738 = (_e2587 << bitcast<u32>(_e1018));
let _e2750 = (_e2559 + 1i);
let _e2753 = select(_e2750, 0i, (_e2750 < 0i));
let _e2754 = (_e2753 >= _e2534.member);
if _e2754 {
phi_89747_ = (_e2534.member - 1i);
} else {
phi_89747_ = _e2753;
}
let _e2757 = phi_89747_;
if _e2590 {
phi_89758_ = (_e2534.member_1 - 1i);
} else {
phi_89758_ = _e2589;
}
let _e2760 = phi_89758_;
let _e2764 = (((f32(_e2757) + 0.5f) * _e2539) - 0.5f);
let _e2768 = (((f32(_e2760) + 0.5f) * _e2539) - 0.5f);
if _e487 {
phi_89786_ = type_26(_e2760, _e2757);
} else {
phi_89786_ = type_26(_e2757, _e2760);
}
let _e2774 = phi_89786_;
if _e1017 {
phi_89837_ = 0u;
} else {
if (_e800 == 1u) {
phi_89836_ = 0u;
} else {
if (_e800 == 2u) {
phi_89835_ = _e2616;
} else {
phi_89835_ = select(_e2622, _e2619, (_e800 == 3u));
}
let _e2782 = phi_89835_;
phi_89836_ = _e2782;
}
let _e2784 = phi_89836_;
phi_89837_ = _e2784;
}
let _e2786 = phi_89837_;
local_20 = (((bitcast<i32>(_e2786) + _e2774.member_1) * _e2613) + _e2774.member);
let _e2791 = local_20;
let _e2793 = select(_e2639, _e2791, (_e2791 < _e2639));
let _e2798 = global_6.member[bitcast<u32>(select(0i, _e2793, (_e2793 > 0i)))];
let _e2803 = (((((select(_e2764, _e2768, _e487) + 0.5f) / _e2157) * 2f) - 1f) * _e2165);
let _e2808 = ((1f - (((select(_e2768, _e2764, _e487) + 0.5f) / _e2158) * 2f)) * _e2173);
let _e2815 = ((_e2176.member * _e2803) + (_e2184.member * _e2808));
let _e2816 = ((_e2176.member_1 * _e2803) + (_e2184.member_1 * _e2808));
let _e2817 = ((_e2176.member_2 * _e2803) + (_e2184.member_2 * _e2808));
let _e2821 = select((_e2199.member + _e2815), _e2199.member, _e2197);
let _e2822 = select((_e2199.member_1 + _e2816), _e2199.member_1, _e2197);
let _e2823 = select((_e2199.member_2 + _e2817), _e2199.member_2, _e2197);
let _e2834 = (((_e2821 * _e2821) + (_e2822 * _e2822)) + (_e2823 * _e2823));
let _e2838 = (1f / sqrt(select(0f, _e2834, (_e2834 > 0f))));
let _e2839 = (_e2821 * _e2838);
let _e2840 = (_e2822 * _e2838);
let _e2841 = (_e2823 * _e2838);
let _e2842 = (_e609 - select(_e2210.member, (_e2210.member + _e2815), _e2197));
let _e2843 = (_e621 - select(_e2210.member_1, (_e2210.member_1 + _e2816), _e2197));
let _e2844 = (_e634 - select(_e2210.member_2, (_e2210.member_2 + _e2817), _e2197));
let _e2849 = (((_e2842 * _e2839) + (_e2843 * _e2840)) + (_e2844 * _e2841));
let _e2854 = (((_e2842 * _e647) + (_e2843 * _e660)) + (_e2844 * _e673));
let _e2859 = (((_e2839 * _e647) + (_e2840 * _e660)) + (_e2841 * _e673));
let _e2862 = ((_e2840 * _e673) - (_e2841 * _e660));
let _e2865 = ((_e2841 * _e647) - (_e2839 * _e673));
let _e2868 = ((_e2839 * _e660) - (_e2840 * _e647));
let _e2873 = (((_e2862 * _e2862) + (_e2865 * _e2865)) + (_e2868 * _e2868));
let _e2876 = (1f / select(1e-9f, _e2873, (_e2873 > 1e-9f)));
let _e2879 = ((_e2849 - (_e2859 * _e2854)) * _e2876);
let _e2882 = (((_e2859 * _e2849) - _e2854) * _e2876);
let _e2888 = select(0f, _e2879, (((_e2882 >= 0f) && (_e2882 < _e725)) && (_e2879 > 0f)));
let _e2890 = (_e2757 << bitcast<u32>(_e1018));
let _e2902 = (_e2574 + 1i);
if _e2584 {
phi_90821_ = (_e2534.member - 1i);
} else {
phi_90821_ = _e2583;
}
let _e2906 = phi_90821_;
let _e2908 = select(_e2902, 0i, (_e2902 < 0i));
let _e2909 = (_e2908 >= _e2534.member_1);
if _e2909 {
phi_90832_ = (_e2534.member_1 - 1i);
} else {
phi_90832_ = _e2908;
}
let _e2912 = phi_90832_;
let _e2916 = (((f32(_e2906) + 0.5f) * _e2539) - 0.5f);
let _e2920 = (((f32(_e2912) + 0.5f) * _e2539) - 0.5f);
if _e487 {
phi_90860_ = type_26(_e2912, _e2906);
} else {
phi_90860_ = type_26(_e2906, _e2912);
}
let _e2926 = phi_90860_;
if _e1017 {
phi_90911_ = 0u;
} else {
if (_e800 == 1u) {
phi_90910_ = 0u;
} else {
if (_e800 == 2u) {
phi_90909_ = _e2616;
} else {
phi_90909_ = select(_e2622, _e2619, (_e800 == 3u));
}
let _e2934 = phi_90909_;
phi_90910_ = _e2934;
}
let _e2936 = phi_90910_;
phi_90911_ = _e2936;
}
let _e2938 = phi_90911_;
local_18 = (((bitcast<i32>(_e2938) + _e2926.member_1) * _e2613) + _e2926.member);
let _e2943 = local_18;
let _e2945 = select(_e2639, _e2943, (_e2943 < _e2639));
let _e2950 = global_6.member[bitcast<u32>(select(0i, _e2945, (_e2945 > 0i)))];
let _e2955 = (((((select(_e2916, _e2920, _e487) + 0.5f) / _e2157) * 2f) - 1f) * _e2165);
let _e2960 = ((1f - (((select(_e2920, _e2916, _e487) + 0.5f) / _e2158) * 2f)) * _e2173);
let _e2967 = ((_e2176.member * _e2955) + (_e2184.member * _e2960));
let _e2968 = ((_e2176.member_1 * _e2955) + (_e2184.member_1 * _e2960));
let _e2969 = ((_e2176.member_2 * _e2955) + (_e2184.member_2 * _e2960));
let _e2973 = select((_e2199.member + _e2967), _e2199.member, _e2197);
let _e2974 = select((_e2199.member_1 + _e2968), _e2199.member_1, _e2197);
let _e2975 = select((_e2199.member_2 + _e2969), _e2199.member_2, _e2197);
let _e2986 = (((_e2973 * _e2973) + (_e2974 * _e2974)) + (_e2975 * _e2975));
let _e2990 = (1f / sqrt(select(0f, _e2986, (_e2986 > 0f))));
let _e2991 = (_e2973 * _e2990);
let _e2992 = (_e2974 * _e2990);
let _e2993 = (_e2975 * _e2990);
let _e2994 = (_e609 - select(_e2210.member, (_e2210.member + _e2967), _e2197));
let _e2995 = (_e621 - select(_e2210.member_1, (_e2210.member_1 + _e2968), _e2197));
let _e2996 = (_e634 - select(_e2210.member_2, (_e2210.member_2 + _e2969), _e2197));
let _e3001 = (((_e2994 * _e2991) + (_e2995 * _e2992)) + (_e2996 * _e2993));
let _e3006 = (((_e2994 * _e647) + (_e2995 * _e660)) + (_e2996 * _e673));
let _e3011 = (((_e2991 * _e647) + (_e2992 * _e660)) + (_e2993 * _e673));
let _e3014 = ((_e2992 * _e673) - (_e2993 * _e660));
let _e3017 = ((_e2993 * _e647) - (_e2991 * _e673));
let _e3020 = ((_e2991 * _e660) - (_e2992 * _e647));
let _e3025 = (((_e3014 * _e3014) + (_e3017 * _e3017)) + (_e3020 * _e3020));
let _e3028 = (1f / select(1e-9f, _e3025, (_e3025 > 1e-9f)));
let _e3031 = ((_e3001 - (_e3011 * _e3006)) * _e3028);
let _e3034 = (((_e3011 * _e3001) - _e3006) * _e3028);
let _e3040 = select(0f, _e3031, (((_e3034 >= 0f) && (_e3034 < _e725)) && (_e3031 > 0f)));
let _e3042 = (_e2906 << bitcast<u32>(_e1018));
if _e2754 {
phi_91895_ = (_e2534.member - 1i);
} else {
phi_91895_ = _e2753;
}
let _e3057 = phi_91895_;
if _e2909 {
phi_91906_ = (_e2534.member_1 - 1i);
} else {
phi_91906_ = _e2908;
}
let _e3060 = phi_91906_;
let _e3064 = (((f32(_e3057) + 0.5f) * _e2539) - 0.5f);
let _e3068 = (((f32(_e3060) + 0.5f) * _e2539) - 0.5f);
if _e487 {
phi_91934_ = type_26(_e3060, _e3057);
} else {
phi_91934_ = type_26(_e3057, _e3060);
}
let _e3074 = phi_91934_;
if _e1017 {
phi_91985_ = 0u;
} else {
if (_e800 == 1u) {
phi_91984_ = 0u;
} else {
if (_e800 == 2u) {
phi_91983_ = _e2616;
} else {
phi_91983_ = select(_e2622, _e2619, (_e800 == 3u));
}
let _e3082 = phi_91983_;
phi_91984_ = _e3082;
}
let _e3084 = phi_91984_;
phi_91985_ = _e3084;
}
let _e3086 = phi_91985_;
local_16 = (((bitcast<i32>(_e3086) + _e3074.member_1) * _e2613) + _e3074.member);
let _e3091 = local_16;
let _e3093 = select(_e2639, _e3091, (_e3091 < _e2639));
let _e3098 = global_6.member[bitcast<u32>(select(0i, _e3093, (_e3093 > 0i)))];
let _e3103 = (((((select(_e3064, _e3068, _e487) + 0.5f) / _e2157) * 2f) - 1f) * _e2165);
let _e3108 = ((1f - (((select(_e3068, _e3064, _e487) + 0.5f) / _e2158) * 2f)) * _e2173);
let _e3115 = ((_e2176.member * _e3103) + (_e2184.member * _e3108));
let _e3116 = ((_e2176.member_1 * _e3103) + (_e2184.member_1 * _e3108));
let _e3117 = ((_e2176.member_2 * _e3103) + (_e2184.member_2 * _e3108));
let _e3121 = select((_e2199.member + _e3115), _e2199.member, _e2197);
let _e3122 = select((_e2199.member_1 + _e3116), _e2199.member_1, _e2197);
let _e3123 = select((_e2199.member_2 + _e3117), _e2199.member_2, _e2197);
let _e3134 = (((_e3121 * _e3121) + (_e3122 * _e3122)) + (_e3123 * _e3123));
let _e3138 = (1f / sqrt(select(0f, _e3134, (_e3134 > 0f))));
let _e3139 = (_e3121 * _e3138);
let _e3140 = (_e3122 * _e3138);
let _e3141 = (_e3123 * _e3138);
let _e3142 = (_e609 - select(_e2210.member, (_e2210.member + _e3115), _e2197));
let _e3143 = (_e621 - select(_e2210.member_1, (_e2210.member_1 + _e3116), _e2197));
let _e3144 = (_e634 - select(_e2210.member_2, (_e2210.member_2 + _e3117), _e2197));
let _e3149 = (((_e3142 * _e3139) + (_e3143 * _e3140)) + (_e3144 * _e3141));
let _e3154 = (((_e3142 * _e647) + (_e3143 * _e660)) + (_e3144 * _e673));
let _e3159 = (((_e3139 * _e647) + (_e3140 * _e660)) + (_e3141 * _e673));
let _e3162 = ((_e3140 * _e673) - (_e3141 * _e660));
let _e3165 = ((_e3141 * _e647) - (_e3139 * _e673));
let _e3168 = ((_e3139 * _e660) - (_e3140 * _e647));
let _e3173 = (((_e3162 * _e3162) + (_e3165 * _e3165)) + (_e3168 * _e3168));
let _e3176 = (1f / select(1e-9f, _e3173, (_e3173 > 1e-9f)));
let _e3179 = ((_e3149 - (_e3159 * _e3154)) * _e3176);
let _e3182 = (((_e3159 * _e3149) - _e3154) * _e3176);
let _e3188 = select(0f, _e3179, (((_e3182 >= 0f) && (_e3182 < _e725)) && (_e3179 > 0f)));
let _e3190 = (_e3057 << bitcast<u32>(_e1018));
let _e3202 = select(((((1f - select(0f, (_e2579 * _e2580), (((select(select(_e800, _e957, (_e2738 >= _e726)), _e879, (_e2738 < _e332)) == _e800) && (_e2736 > 0f)) && (_e2736 < _e2646)))) - select(0f, (_e2576 * _e2580), (((select(select(_e800, _e957, (_e2890 >= _e726)), _e879, (_e2890 < _e332)) == _e800) && (_e2888 > 0f)) && (_e2888 < _e2798)))) - select(0f, (_e2579 * _e2578), (((select(select(_e800, _e957, (_e3042 >= _e726)), _e879, (_e3042 < _e332)) == _e800) && (_e3040 > 0f)) && (_e3040 < _e2950)))) - select(0f, (_e2576 * _e2578), (((select(select(_e800, _e957, (_e3190 >= _e726)), _e879, (_e3190 < _e332)) == _e800) && (_e3188 > 0f)) && (_e3188 < _e3098)))), 1f, _e1017);
let _e3203 = (_e1962 & 31u);
let _e3205 = (1u << bitcast<u32>(_e3203));
let _e3214 = bitcast<i32>((((_e962 + _e3205) - 1u) >> bitcast<u32>(_e3203)));
let _e3215 = bitcast<i32>((((_e965 + _e3205) - 1u) >> bitcast<u32>(_e3203)));
if _e487 {
phi_92987_ = type_26(_e3215, _e3214);
} else {
phi_92987_ = type_26(_e3214, _e3215);
}
let _e3219 = phi_92987_;
let _e3224 = f32((1i << bitcast<u32>(_e3203)));
let _e3225 = (1f / _e3224);
let _e3227 = ((_e1983 * _e3225) - 0.5f);
let _e3229 = ((_e2077 * _e3225) - 0.5f);
let _e3231 = select(-1f, _e3227, (_e3227 > -1f));
let _e3233 = select(1e6f, _e3231, (_e3231 < 1e6f));
let _e3240 = select(0i, select(select(i32(_e3233), i32(-2147483648), (_e3233 < -2147483600f)), 2147483647i, (_e3233 > 2147483500f)), (_e3233 == _e3233));
let _e3244 = (_e3240 - select(0i, 1i, (_e3233 < f32(_e3240))));
let _e3246 = select(-1f, _e3229, (_e3229 > -1f));
let _e3248 = select(1e6f, _e3246, (_e3246 < 1e6f));
let _e3255 = select(0i, select(select(i32(_e3248), i32(-2147483648), (_e3248 < -2147483600f)), 2147483647i, (_e3248 > 2147483500f)), (_e3248 == _e3248));
let _e3259 = (_e3255 - select(0i, 1i, (_e3248 < f32(_e3255))));
let _e3261 = (_e3227 - f32(_e3244));
let _e3263 = (_e3229 - f32(_e3259));
let _e3264 = (1f - _e3261);
let _e3265 = (1f - _e3263);
let _e3268 = select(_e3244, 0i, (_e3244 < 0i));
let _e3269 = (_e3268 >= _e3219.member);
if _e3269 {
phi_93065_ = (_e3219.member - 1i);
} else {
phi_93065_ = _e3268;
}
let _e3272 = phi_93065_;
let _e3274 = select(_e3259, 0i, (_e3259 < 0i));
let _e3275 = (_e3274 >= _e3219.member_1);
if _e3275 {
phi_93076_ = (_e3219.member_1 - 1i);
} else {
phi_93076_ = _e3274;
}
let _e3278 = phi_93076_;
let _e3282 = (((f32(_e3272) + 0.5f) * _e3224) - 0.5f);
let _e3286 = (((f32(_e3278) + 0.5f) * _e3224) - 0.5f);
if _e487 {
phi_93104_ = type_26(_e3278, _e3272);
} else {
phi_93104_ = type_26(_e3272, _e3278);
}
let _e3292 = phi_93104_;
let _e3295 = (_e1962 == 0u);
if _e3295 {
phi_93155_ = 0u;
} else {
if (_e1962 == 1u) {
phi_93154_ = 0u;
} else {
if (_e1962 == 2u) {
phi_93153_ = _e2616;
} else {
phi_93153_ = select(_e2622, _e2619, (_e1962 == 3u));
}
let _e3301 = phi_93153_;
phi_93154_ = _e3301;
}
let _e3303 = phi_93154_;
phi_93155_ = _e3303;
}
let _e3305 = phi_93155_;
local_14 = (((bitcast<i32>(_e3305) + _e3292.member_1) * _e2613) + _e3292.member);
let _e3310 = local_14;
let _e3312 = select(_e2639, _e3310, (_e3310 < _e2639));
let _e3317 = global_6.member[bitcast<u32>(select(0i, _e3312, (_e3312 > 0i)))];
let _e3322 = (((((select(_e3282, _e3286, _e487) + 0.5f) / _e2157) * 2f) - 1f) * _e2165);
let _e3327 = ((1f - (((select(_e3286, _e3282, _e487) + 0.5f) / _e2158) * 2f)) * _e2173);
let _e3334 = ((_e2176.member * _e3322) + (_e2184.member * _e3327));
let _e3335 = ((_e2176.member_1 * _e3322) + (_e2184.member_1 * _e3327));
let _e3336 = ((_e2176.member_2 * _e3322) + (_e2184.member_2 * _e3327));
let _e3340 = select((_e2199.member + _e3334), _e2199.member, _e2197);
let _e3341 = select((_e2199.member_1 + _e3335), _e2199.member_1, _e2197);
let _e3342 = select((_e2199.member_2 + _e3336), _e2199.member_2, _e2197);
let _e3353 = (((_e3340 * _e3340) + (_e3341 * _e3341)) + (_e3342 * _e3342));
let _e3357 = (1f / sqrt(select(0f, _e3353, (_e3353 > 0f))));
let _e3358 = (_e3340 * _e3357);
let _e3359 = (_e3341 * _e3357);
let _e3360 = (_e3342 * _e3357);
let _e3361 = (_e609 - select(_e2210.member, (_e2210.member + _e3334), _e2197));
let _e3362 = (_e621 - select(_e2210.member_1, (_e2210.member_1 + _e3335), _e2197));
let _e3363 = (_e634 - select(_e2210.member_2, (_e2210.member_2 + _e3336), _e2197));
let _e3368 = (((_e3361 * _e3358) + (_e3362 * _e3359)) + (_e3363 * _e3360));
let _e3373 = (((_e3361 * _e647) + (_e3362 * _e660)) + (_e3363 * _e673));
let _e3378 = (((_e3358 * _e647) + (_e3359 * _e660)) + (_e3360 * _e673));
let _e3381 = ((_e3359 * _e673) - (_e3360 * _e660));
let _e3384 = ((_e3360 * _e647) - (_e3358 * _e673));
let _e3387 = ((_e3358 * _e660) - (_e3359 * _e647));
let _e3392 = (((_e3381 * _e3381) + (_e3384 * _e3384)) + (_e3387 * _e3387));
let _e3395 = (1f / select(1e-9f, _e3392, (_e3392 > 1e-9f)));
let _e3398 = ((_e3368 - (_e3378 * _e3373)) * _e3395);
let _e3401 = (((_e3378 * _e3368) - _e3373) * _e3395);
let _e3407 = select(0f, _e3398, (((_e3401 >= 0f) && (_e3401 < _e725)) && (_e3398 > 0f)));
let _e3409 = (_e3272 << bitcast<u32>(_e3203));
let _e3421 = (_e3244 + 1i);
let _e3424 = select(_e3421, 0i, (_e3421 < 0i));
let _e3425 = (_e3424 >= _e3219.member);
if _e3425 {
phi_94139_ = (_e3219.member - 1i);
} else {
phi_94139_ = _e3424;
}
let _e3428 = phi_94139_;
if _e3275 {
phi_94150_ = (_e3219.member_1 - 1i);
} else {
phi_94150_ = _e3274;
}
let _e3431 = phi_94150_;
let _e3435 = (((f32(_e3428) + 0.5f) * _e3224) - 0.5f);
let _e3439 = (((f32(_e3431) + 0.5f) * _e3224) - 0.5f);
if _e487 {
phi_94178_ = type_26(_e3431, _e3428);
} else {
phi_94178_ = type_26(_e3428, _e3431);
}
let _e3445 = phi_94178_;
if _e3295 {
phi_94229_ = 0u;
} else {
if (_e1962 == 1u) {
phi_94228_ = 0u;
} else {
if (_e1962 == 2u) {
phi_94227_ = _e2616;
} else {
phi_94227_ = select(_e2622, _e2619, (_e1962 == 3u));
}
let _e3453 = phi_94227_;
phi_94228_ = _e3453;
}
let _e3455 = phi_94228_;
phi_94229_ = _e3455;
}
let _e3457 = phi_94229_;
local_12 = (((bitcast<i32>(_e3457) + _e3445.member_1) * _e2613) + _e3445.member);
let _e3462 = local_12;
let _e3464 = select(_e2639, _e3462, (_e3462 < _e2639));
let _e3469 = global_6.member[bitcast<u32>(select(0i, _e3464, (_e3464 > 0i)))];
let _e3474 = (((((select(_e3435, _e3439, _e487) + 0.5f) / _e2157) * 2f) - 1f) * _e2165);
let _e3479 = ((1f - (((select(_e3439, _e3435, _e487) + 0.5f) / _e2158) * 2f)) * _e2173);
let _e3486 = ((_e2176.member * _e3474) + (_e2184.member * _e3479));
let _e3487 = ((_e2176.member_1 * _e3474) + (_e2184.member_1 * _e3479));
let _e3488 = ((_e2176.member_2 * _e3474) + (_e2184.member_2 * _e3479));
let _e3492 = select((_e2199.member + _e3486), _e2199.member, _e2197);
let _e3493 = select((_e2199.member_1 + _e3487), _e2199.member_1, _e2197);
let _e3494 = select((_e2199.member_2 + _e3488), _e2199.member_2, _e2197);
let _e3505 = (((_e3492 * _e3492) + (_e3493 * _e3493)) + (_e3494 * _e3494));
let _e3509 = (1f / sqrt(select(0f, _e3505, (_e3505 > 0f))));
let _e3510 = (_e3492 * _e3509);
let _e3511 = (_e3493 * _e3509);
let _e3512 = (_e3494 * _e3509);
let _e3513 = (_e609 - select(_e2210.member, (_e2210.member + _e3486), _e2197));
let _e3514 = (_e621 - select(_e2210.member_1, (_e2210.member_1 + _e3487), _e2197));
let _e3515 = (_e634 - select(_e2210.member_2, (_e2210.member_2 + _e3488), _e2197));
let _e3520 = (((_e3513 * _e3510) + (_e3514 * _e3511)) + (_e3515 * _e3512));
let _e3525 = (((_e3513 * _e647) + (_e3514 * _e660)) + (_e3515 * _e673));
let _e3530 = (((_e3510 * _e647) + (_e3511 * _e660)) + (_e3512 * _e673));
let _e3533 = ((_e3511 * _e673) - (_e3512 * _e660));
let _e3536 = ((_e3512 * _e647) - (_e3510 * _e673));
let _e3539 = ((_e3510 * _e660) - (_e3511 * _e647));
let _e3544 = (((_e3533 * _e3533) + (_e3536 * _e3536)) + (_e3539 * _e3539));
let _e3547 = (1f / select(1e-9f, _e3544, (_e3544 > 1e-9f)));
let _e3550 = ((_e3520 - (_e3530 * _e3525)) * _e3547);
let _e3553 = (((_e3530 * _e3520) - _e3525) * _e3547);
let _e3559 = select(0f, _e3550, (((_e3553 >= 0f) && (_e3553 < _e725)) && (_e3550 > 0f)));
let _e3561 = (_e3428 << bitcast<u32>(_e3203));
let _e3573 = (_e3259 + 1i);
if _e3269 {
phi_95213_ = (_e3219.member - 1i);
} else {
phi_95213_ = _e3268;
}
let _e3577 = phi_95213_;
let _e3579 = select(_e3573, 0i, (_e3573 < 0i));
let _e3580 = (_e3579 >= _e3219.member_1);
if _e3580 {
phi_95224_ = (_e3219.member_1 - 1i);
} else {
phi_95224_ = _e3579;
}
let _e3583 = phi_95224_;
let _e3587 = (((f32(_e3577) + 0.5f) * _e3224) - 0.5f);
let _e3591 = (((f32(_e3583) + 0.5f) * _e3224) - 0.5f);
if _e487 {
phi_95252_ = type_26(_e3583, _e3577);
} else {
phi_95252_ = type_26(_e3577, _e3583);
}
let _e3597 = phi_95252_;
if _e3295 {
phi_95303_ = 0u;
} else {
if (_e1962 == 1u) {
phi_95302_ = 0u;
} else {
if (_e1962 == 2u) {
phi_95301_ = _e2616;
} else {
phi_95301_ = select(_e2622, _e2619, (_e1962 == 3u));
}
let _e3605 = phi_95301_;
phi_95302_ = _e3605;
}
let _e3607 = phi_95302_;
phi_95303_ = _e3607;
}
let _e3609 = phi_95303_;
local_10 = (((bitcast<i32>(_e3609) + _e3597.member_1) * _e2613) + _e3597.member);
let _e3614 = local_10;
let _e3616 = select(_e2639, _e3614, (_e3614 < _e2639));
let _e3621 = global_6.member[bitcast<u32>(select(0i, _e3616, (_e3616 > 0i)))];
let _e3626 = (((((select(_e3587, _e3591, _e487) + 0.5f) / _e2157) * 2f) - 1f) * _e2165);
let _e3631 = ((1f - (((select(_e3591, _e3587, _e487) + 0.5f) / _e2158) * 2f)) * _e2173);
let _e3638 = ((_e2176.member * _e3626) + (_e2184.member * _e3631));
let _e3639 = ((_e2176.member_1 * _e3626) + (_e2184.member_1 * _e3631));
let _e3640 = ((_e2176.member_2 * _e3626) + (_e2184.member_2 * _e3631));
let _e3644 = select((_e2199.member + _e3638), _e2199.member, _e2197);
let _e3645 = select((_e2199.member_1 + _e3639), _e2199.member_1, _e2197);
let _e3646 = select((_e2199.member_2 + _e3640), _e2199.member_2, _e2197);
let _e3657 = (((_e3644 * _e3644) + (_e3645 * _e3645)) + (_e3646 * _e3646));
let _e3661 = (1f / sqrt(select(0f, _e3657, (_e3657 > 0f))));
let _e3662 = (_e3644 * _e3661);
let _e3663 = (_e3645 * _e3661);
let _e3664 = (_e3646 * _e3661);
let _e3665 = (_e609 - select(_e2210.member, (_e2210.member + _e3638), _e2197));
let _e3666 = (_e621 - select(_e2210.member_1, (_e2210.member_1 + _e3639), _e2197));
let _e3667 = (_e634 - select(_e2210.member_2, (_e2210.member_2 + _e3640), _e2197));
let _e3672 = (((_e3665 * _e3662) + (_e3666 * _e3663)) + (_e3667 * _e3664));
let _e3677 = (((_e3665 * _e647) + (_e3666 * _e660)) + (_e3667 * _e673));
let _e3682 = (((_e3662 * _e647) + (_e3663 * _e660)) + (_e3664 * _e673));
let _e3685 = ((_e3663 * _e673) - (_e3664 * _e660));
let _e3688 = ((_e3664 * _e647) - (_e3662 * _e673));
let _e3691 = ((_e3662 * _e660) - (_e3663 * _e647));
let _e3696 = (((_e3685 * _e3685) + (_e3688 * _e3688)) + (_e3691 * _e3691));
let _e3699 = (1f / select(1e-9f, _e3696, (_e3696 > 1e-9f)));
let _e3702 = ((_e3672 - (_e3682 * _e3677)) * _e3699);
let _e3705 = (((_e3682 * _e3672) - _e3677) * _e3699);
let _e3711 = select(0f, _e3702, (((_e3705 >= 0f) && (_e3705 < _e725)) && (_e3702 > 0f)));
let _e3713 = (_e3577 << bitcast<u32>(_e3203));
if _e3425 {
phi_96287_ = (_e3219.member - 1i);
} else {
phi_96287_ = _e3424;
}
let _e3728 = phi_96287_;
if _e3580 {
phi_96298_ = (_e3219.member_1 - 1i);
} else {
phi_96298_ = _e3579;
}
let _e3731 = phi_96298_;
let _e3735 = (((f32(_e3728) + 0.5f) * _e3224) - 0.5f);
let _e3739 = (((f32(_e3731) + 0.5f) * _e3224) - 0.5f);
if _e487 {
phi_96326_ = type_26(_e3731, _e3728);
} else {
phi_96326_ = type_26(_e3728, _e3731);
}
let _e3745 = phi_96326_;
if _e3295 {
phi_96377_ = 0u;
} else {
if (_e1962 == 1u) {
phi_96376_ = 0u;
} else {
if (_e1962 == 2u) {
phi_96375_ = _e2616;
} else {
phi_96375_ = select(_e2622, _e2619, (_e1962 == 3u));
}
let _e3753 = phi_96375_;
phi_96376_ = _e3753;
}
let _e3755 = phi_96376_;
phi_96377_ = _e3755;
}
let _e3757 = phi_96377_;
local_8 = (((bitcast<i32>(_e3757) + _e3745.member_1) * _e2613) + _e3745.member);
let _e3762 = local_8;
let _e3764 = select(_e2639, _e3762, (_e3762 < _e2639));
let _e3769 = global_6.member[bitcast<u32>(select(0i, _e3764, (_e3764 > 0i)))];
let _e3774 = (((((select(_e3735, _e3739, _e487) + 0.5f) / _e2157) * 2f) - 1f) * _e2165);
let _e3779 = ((1f - (((select(_e3739, _e3735, _e487) + 0.5f) / _e2158) * 2f)) * _e2173);
let _e3786 = ((_e2176.member * _e3774) + (_e2184.member * _e3779));
let _e3787 = ((_e2176.member_1 * _e3774) + (_e2184.member_1 * _e3779));
let _e3788 = ((_e2176.member_2 * _e3774) + (_e2184.member_2 * _e3779));
let _e3792 = select((_e2199.member + _e3786), _e2199.member, _e2197);
let _e3793 = select((_e2199.member_1 + _e3787), _e2199.member_1, _e2197);
let _e3794 = select((_e2199.member_2 + _e3788), _e2199.member_2, _e2197);
let _e3805 = (((_e3792 * _e3792) + (_e3793 * _e3793)) + (_e3794 * _e3794));
let _e3809 = (1f / sqrt(select(0f, _e3805, (_e3805 > 0f))));
let _e3810 = (_e3792 * _e3809);
let _e3811 = (_e3793 * _e3809);
let _e3812 = (_e3794 * _e3809);
let _e3813 = (_e609 - select(_e2210.member, (_e2210.member + _e3786), _e2197));
let _e3814 = (_e621 - select(_e2210.member_1, (_e2210.member_1 + _e3787), _e2197));
let _e3815 = (_e634 - select(_e2210.member_2, (_e2210.member_2 + _e3788), _e2197));
let _e3820 = (((_e3813 * _e3810) + (_e3814 * _e3811)) + (_e3815 * _e3812));
let _e3825 = (((_e3813 * _e647) + (_e3814 * _e660)) + (_e3815 * _e673));
let _e3830 = (((_e3810 * _e647) + (_e3811 * _e660)) + (_e3812 * _e673));
let _e3833 = ((_e3811 * _e673) - (_e3812 * _e660));
let _e3836 = ((_e3812 * _e647) - (_e3810 * _e673));
let _e3839 = ((_e3810 * _e660) - (_e3811 * _e647));
let _e3844 = (((_e3833 * _e3833) + (_e3836 * _e3836)) + (_e3839 * _e3839));
let _e3847 = (1f / select(1e-9f, _e3844, (_e3844 > 1e-9f)));
let _e3850 = ((_e3820 - (_e3830 * _e3825)) * _e3847);
let _e3853 = (((_e3830 * _e3820) - _e3825) * _e3847);
let _e3859 = select(0f, _e3850, (((_e3853 >= 0f) && (_e3853 < _e725)) && (_e3850 > 0f)));
let _e3861 = (_e3728 << bitcast<u32>(_e3203));
let _e3873 = select(((((_e3202 - select(0f, (_e3264 * _e3265), (((select(select(_e800, _e957, (_e3409 >= _e726)), _e879, (_e3409 < _e332)) == _e1962) && (_e3407 > 0f)) && (_e3407 < _e3317)))) - select(0f, (_e3261 * _e3265), (((select(select(_e800, _e957, (_e3561 >= _e726)), _e879, (_e3561 < _e332)) == _e1962) && (_e3559 > 0f)) && (_e3559 < _e3469)))) - select(0f, (_e3264 * _e3263), (((select(select(_e800, _e957, (_e3713 >= _e726)), _e879, (_e3713 < _e332)) == _e1962) && (_e3711 > 0f)) && (_e3711 < _e3621)))) - select(0f, (_e3261 * _e3263), (((select(select(_e800, _e957, (_e3861 >= _e726)), _e879, (_e3861 < _e332)) == _e1962) && (_e3859 > 0f)) && (_e3859 < _e3769)))), _e3202, _e3295);
let _e3874 = (_e1966 & 31u);
let _e3876 = (1u << bitcast<u32>(_e3874));
let _e3885 = bitcast<i32>((((_e962 + _e3876) - 1u) >> bitcast<u32>(_e3874)));
let _e3886 = bitcast<i32>((((_e965 + _e3876) - 1u) >> bitcast<u32>(_e3874)));
if _e487 {
phi_97379_ = type_26(_e3886, _e3885);
} else {
phi_97379_ = type_26(_e3885, _e3886);
}
let _e3890 = phi_97379_;
let _e3895 = f32((1i << bitcast<u32>(_e3874)));
let _e3896 = (1f / _e3895);
let _e3898 = ((_e1983 * _e3896) - 0.5f);
let _e3900 = ((_e2077 * _e3896) - 0.5f);
let _e3902 = select(-1f, _e3898, (_e3898 > -1f));
let _e3904 = select(1e6f, _e3902, (_e3902 < 1e6f));
let _e3911 = select(0i, select(select(i32(_e3904), i32(-2147483648), (_e3904 < -2147483600f)), 2147483647i, (_e3904 > 2147483500f)), (_e3904 == _e3904));
let _e3915 = (_e3911 - select(0i, 1i, (_e3904 < f32(_e3911))));
let _e3917 = select(-1f, _e3900, (_e3900 > -1f));
let _e3919 = select(1e6f, _e3917, (_e3917 < 1e6f));
let _e3926 = select(0i, select(select(i32(_e3919), i32(-2147483648), (_e3919 < -2147483600f)), 2147483647i, (_e3919 > 2147483500f)), (_e3919 == _e3919));
let _e3930 = (_e3926 - select(0i, 1i, (_e3919 < f32(_e3926))));
let _e3932 = (_e3898 - f32(_e3915));
let _e3934 = (_e3900 - f32(_e3930));
let _e3935 = (1f - _e3932);
let _e3936 = (1f - _e3934);
let _e3939 = select(_e3915, 0i, (_e3915 < 0i));
let _e3940 = (_e3939 >= _e3890.member);
if _e3940 {
phi_97457_ = (_e3890.member - 1i);
} else {
phi_97457_ = _e3939;
}
let _e3943 = phi_97457_;
let _e3945 = select(_e3930, 0i, (_e3930 < 0i));
let _e3946 = (_e3945 >= _e3890.member_1);
if _e3946 {
phi_97468_ = (_e3890.member_1 - 1i);
} else {
phi_97468_ = _e3945;
}
let _e3949 = phi_97468_;
let _e3953 = (((f32(_e3943) + 0.5f) * _e3895) - 0.5f);
let _e3957 = (((f32(_e3949) + 0.5f) * _e3895) - 0.5f);
if _e487 {
phi_97496_ = type_26(_e3949, _e3943);
} else {
phi_97496_ = type_26(_e3943, _e3949);
}
let _e3963 = phi_97496_;
let _e3966 = (_e1966 == 0u);
if _e3966 {
phi_97547_ = 0u;
} else {
if (_e1966 == 1u) {
phi_97546_ = 0u;
} else {
if (_e1966 == 2u) {
phi_97545_ = _e2616;
} else {
phi_97545_ = select(_e2622, _e2619, (_e1966 == 3u));
}
let _e3972 = phi_97545_;
phi_97546_ = _e3972;
}
let _e3974 = phi_97546_;
phi_97547_ = _e3974;
}
let _e3976 = phi_97547_;
local_6 = (((bitcast<i32>(_e3976) + _e3963.member_1) * _e2613) + _e3963.member);
let _e3981 = local_6;
let _e3983 = select(_e2639, _e3981, (_e3981 < _e2639));
let _e3988 = global_6.member[bitcast<u32>(select(0i, _e3983, (_e3983 > 0i)))];
let _e3993 = (((((select(_e3953, _e3957, _e487) + 0.5f) / _e2157) * 2f) - 1f) * _e2165);
let _e3998 = ((1f - (((select(_e3957, _e3953, _e487) + 0.5f) / _e2158) * 2f)) * _e2173);
let _e4005 = ((_e2176.member * _e3993) + (_e2184.member * _e3998));
let _e4006 = ((_e2176.member_1 * _e3993) + (_e2184.member_1 * _e3998));
let _e4007 = ((_e2176.member_2 * _e3993) + (_e2184.member_2 * _e3998));
let _e4011 = select((_e2199.member + _e4005), _e2199.member, _e2197);
let _e4012 = select((_e2199.member_1 + _e4006), _e2199.member_1, _e2197);
let _e4013 = select((_e2199.member_2 + _e4007), _e2199.member_2, _e2197);
let _e4024 = (((_e4011 * _e4011) + (_e4012 * _e4012)) + (_e4013 * _e4013));
let _e4028 = (1f / sqrt(select(0f, _e4024, (_e4024 > 0f))));
let _e4029 = (_e4011 * _e4028);
let _e4030 = (_e4012 * _e4028);
let _e4031 = (_e4013 * _e4028);
let _e4032 = (_e609 - select(_e2210.member, (_e2210.member + _e4005), _e2197));
let _e4033 = (_e621 - select(_e2210.member_1, (_e2210.member_1 + _e4006), _e2197));
let _e4034 = (_e634 - select(_e2210.member_2, (_e2210.member_2 + _e4007), _e2197));
let _e4039 = (((_e4032 * _e4029) + (_e4033 * _e4030)) + (_e4034 * _e4031));
let _e4044 = (((_e4032 * _e647) + (_e4033 * _e660)) + (_e4034 * _e673));
let _e4049 = (((_e4029 * _e647) + (_e4030 * _e660)) + (_e4031 * _e673));
let _e4052 = ((_e4030 * _e673) - (_e4031 * _e660));
let _e4055 = ((_e4031 * _e647) - (_e4029 * _e673));
let _e4058 = ((_e4029 * _e660) - (_e4030 * _e647));
let _e4063 = (((_e4052 * _e4052) + (_e4055 * _e4055)) + (_e4058 * _e4058));
let _e4066 = (1f / select(1e-9f, _e4063, (_e4063 > 1e-9f)));
let _e4069 = ((_e4039 - (_e4049 * _e4044)) * _e4066);
let _e4072 = (((_e4049 * _e4039) - _e4044) * _e4066);
let _e4078 = select(0f, _e4069, (((_e4072 >= 0f) && (_e4072 < _e725)) && (_e4069 > 0f)));
let _e4080 = (_e3943 << bitcast<u32>(_e3874));
let _e4092 = (_e3915 + 1i);
let _e4095 = select(_e4092, 0i, (_e4092 < 0i));
let _e4096 = (_e4095 >= _e3890.member);
if _e4096 {
phi_98531_ = (_e3890.member - 1i);
} else {
phi_98531_ = _e4095;
}
let _e4099 = phi_98531_;
if _e3946 {
phi_98542_ = (_e3890.member_1 - 1i);
} else {
phi_98542_ = _e3945;
}
let _e4102 = phi_98542_;
let _e4106 = (((f32(_e4099) + 0.5f) * _e3895) - 0.5f);
let _e4110 = (((f32(_e4102) + 0.5f) * _e3895) - 0.5f);
if _e487 {
phi_98570_ = type_26(_e4102, _e4099);
} else {
phi_98570_ = type_26(_e4099, _e4102);
}
let _e4116 = phi_98570_;
if _e3966 {
phi_98621_ = 0u;
} else {
if (_e1966 == 1u) {
phi_98620_ = 0u;
} else {
if (_e1966 == 2u) {
phi_98619_ = _e2616;
} else {
phi_98619_ = select(_e2622, _e2619, (_e1966 == 3u));
}
let _e4124 = phi_98619_;
phi_98620_ = _e4124;
}
let _e4126 = phi_98620_;
phi_98621_ = _e4126;
}
let _e4128 = phi_98621_;
local_4 = (((bitcast<i32>(_e4128) + _e4116.member_1) * _e2613) + _e4116.member);
let _e4133 = local_4;
let _e4135 = select(_e2639, _e4133, (_e4133 < _e2639));
let _e4140 = global_6.member[bitcast<u32>(select(0i, _e4135, (_e4135 > 0i)))];
let _e4145 = (((((select(_e4106, _e4110, _e487) + 0.5f) / _e2157) * 2f) - 1f) * _e2165);
let _e4150 = ((1f - (((select(_e4110, _e4106, _e487) + 0.5f) / _e2158) * 2f)) * _e2173);
let _e4157 = ((_e2176.member * _e4145) + (_e2184.member * _e4150));
let _e4158 = ((_e2176.member_1 * _e4145) + (_e2184.member_1 * _e4150));
let _e4159 = ((_e2176.member_2 * _e4145) + (_e2184.member_2 * _e4150));
let _e4163 = select((_e2199.member + _e4157), _e2199.member, _e2197);
let _e4164 = select((_e2199.member_1 + _e4158), _e2199.member_1, _e2197);
let _e4165 = select((_e2199.member_2 + _e4159), _e2199.member_2, _e2197);
let _e4176 = (((_e4163 * _e4163) + (_e4164 * _e4164)) + (_e4165 * _e4165));
let _e4180 = (1f / sqrt(select(0f, _e4176, (_e4176 > 0f))));
let _e4181 = (_e4163 * _e4180);
let _e4182 = (_e4164 * _e4180);
let _e4183 = (_e4165 * _e4180);
let _e4184 = (_e609 - select(_e2210.member, (_e2210.member + _e4157), _e2197));
let _e4185 = (_e621 - select(_e2210.member_1, (_e2210.member_1 + _e4158), _e2197));
let _e4186 = (_e634 - select(_e2210.member_2, (_e2210.member_2 + _e4159), _e2197));
let _e4191 = (((_e4184 * _e4181) + (_e4185 * _e4182)) + (_e4186 * _e4183));
let _e4196 = (((_e4184 * _e647) + (_e4185 * _e660)) + (_e4186 * _e673));
let _e4201 = (((_e4181 * _e647) + (_e4182 * _e660)) + (_e4183 * _e673));
let _e4204 = ((_e4182 * _e673) - (_e4183 * _e660));
let _e4207 = ((_e4183 * _e647) - (_e4181 * _e673));
let _e4210 = ((_e4181 * _e660) - (_e4182 * _e647));
let _e4215 = (((_e4204 * _e4204) + (_e4207 * _e4207)) + (_e4210 * _e4210));
let _e4218 = (1f / select(1e-9f, _e4215, (_e4215 > 1e-9f)));
let _e4221 = ((_e4191 - (_e4201 * _e4196)) * _e4218);
let _e4224 = (((_e4201 * _e4191) - _e4196) * _e4218);
let _e4230 = select(0f, _e4221, (((_e4224 >= 0f) && (_e4224 < _e725)) && (_e4221 > 0f)));
let _e4232 = (_e4099 << bitcast<u32>(_e3874));
let _e4244 = (_e3930 + 1i);
if _e3940 {
phi_99605_ = (_e3890.member - 1i);
} else {
phi_99605_ = _e3939;
}
let _e4248 = phi_99605_;
let _e4250 = select(_e4244, 0i, (_e4244 < 0i));
let _e4251 = (_e4250 >= _e3890.member_1);
if _e4251 {
phi_99616_ = (_e3890.member_1 - 1i);
} else {
phi_99616_ = _e4250;
}
let _e4254 = phi_99616_;
let _e4258 = (((f32(_e4248) + 0.5f) * _e3895) - 0.5f);
let _e4262 = (((f32(_e4254) + 0.5f) * _e3895) - 0.5f);
if _e487 {
phi_99644_ = type_26(_e4254, _e4248);
} else {
phi_99644_ = type_26(_e4248, _e4254);
}
let _e4268 = phi_99644_;
if _e3966 {
phi_99695_ = 0u;
} else {
if (_e1966 == 1u) {
phi_99694_ = 0u;
} else {
if (_e1966 == 2u) {
phi_99693_ = _e2616;
} else {
phi_99693_ = select(_e2622, _e2619, (_e1966 == 3u));
}
let _e4276 = phi_99693_;
phi_99694_ = _e4276;
}
let _e4278 = phi_99694_;
phi_99695_ = _e4278;
}
let _e4280 = phi_99695_;
local_2 = (((bitcast<i32>(_e4280) + _e4268.member_1) * _e2613) + _e4268.member);
let _e4285 = local_2;
let _e4287 = select(_e2639, _e4285, (_e4285 < _e2639));
let _e4292 = global_6.member[bitcast<u32>(select(0i, _e4287, (_e4287 > 0i)))];
let _e4297 = (((((select(_e4258, _e4262, _e487) + 0.5f) / _e2157) * 2f) - 1f) * _e2165);
let _e4302 = ((1f - (((select(_e4262, _e4258, _e487) + 0.5f) / _e2158) * 2f)) * _e2173);
let _e4309 = ((_e2176.member * _e4297) + (_e2184.member * _e4302));
let _e4310 = ((_e2176.member_1 * _e4297) + (_e2184.member_1 * _e4302));
let _e4311 = ((_e2176.member_2 * _e4297) + (_e2184.member_2 * _e4302));
let _e4315 = select((_e2199.member + _e4309), _e2199.member, _e2197);
let _e4316 = select((_e2199.member_1 + _e4310), _e2199.member_1, _e2197);
let _e4317 = select((_e2199.member_2 + _e4311), _e2199.member_2, _e2197);
let _e4328 = (((_e4315 * _e4315) + (_e4316 * _e4316)) + (_e4317 * _e4317));
let _e4332 = (1f / sqrt(select(0f, _e4328, (_e4328 > 0f))));
let _e4333 = (_e4315 * _e4332);
let _e4334 = (_e4316 * _e4332);
let _e4335 = (_e4317 * _e4332);
let _e4336 = (_e609 - select(_e2210.member, (_e2210.member + _e4309), _e2197));
let _e4337 = (_e621 - select(_e2210.member_1, (_e2210.member_1 + _e4310), _e2197));
let _e4338 = (_e634 - select(_e2210.member_2, (_e2210.member_2 + _e4311), _e2197));
let _e4343 = (((_e4336 * _e4333) + (_e4337 * _e4334)) + (_e4338 * _e4335));
let _e4348 = (((_e4336 * _e647) + (_e4337 * _e660)) + (_e4338 * _e673));
let _e4353 = (((_e4333 * _e647) + (_e4334 * _e660)) + (_e4335 * _e673));
let _e4356 = ((_e4334 * _e673) - (_e4335 * _e660));
let _e4359 = ((_e4335 * _e647) - (_e4333 * _e673));
let _e4362 = ((_e4333 * _e660) - (_e4334 * _e647));
let _e4367 = (((_e4356 * _e4356) + (_e4359 * _e4359)) + (_e4362 * _e4362));
let _e4370 = (1f / select(1e-9f, _e4367, (_e4367 > 1e-9f)));
let _e4373 = ((_e4343 - (_e4353 * _e4348)) * _e4370);
let _e4376 = (((_e4353 * _e4343) - _e4348) * _e4370);
let _e4382 = select(0f, _e4373, (((_e4376 >= 0f) && (_e4376 < _e725)) && (_e4373 > 0f)));
let _e4384 = (_e4248 << bitcast<u32>(_e3874));
if _e4096 {
phi_100679_ = (_e3890.member - 1i);
} else {
phi_100679_ = _e4095;
}
let _e4399 = phi_100679_;
if _e4251 {
phi_100690_ = (_e3890.member_1 - 1i);
} else {
phi_100690_ = _e4250;
}
let _e4402 = phi_100690_;
let _e4406 = (((f32(_e4399) + 0.5f) * _e3895) - 0.5f);
let _e4410 = (((f32(_e4402) + 0.5f) * _e3895) - 0.5f);
if _e487 {
phi_100718_ = type_26(_e4402, _e4399);
} else {
phi_100718_ = type_26(_e4399, _e4402);
}
let _e4416 = phi_100718_;
if _e3966 {
phi_100769_ = 0u;
} else {
if (_e1966 == 1u) {
phi_100768_ = 0u;
} else {
if (_e1966 == 2u) {
phi_100767_ = _e2616;
} else {
phi_100767_ = select(_e2622, _e2619, (_e1966 == 3u));
}
let _e4424 = phi_100767_;
phi_100768_ = _e4424;
}
let _e4426 = phi_100768_;
phi_100769_ = _e4426;
}
let _e4428 = phi_100769_;
local = (((bitcast<i32>(_e4428) + _e4416.member_1) * _e2613) + _e4416.member);
let _e4433 = local;
let _e4435 = select(_e2639, _e4433, (_e4433 < _e2639));
let _e4440 = global_6.member[bitcast<u32>(select(0i, _e4435, (_e4435 > 0i)))];
let _e4445 = (((((select(_e4406, _e4410, _e487) + 0.5f) / _e2157) * 2f) - 1f) * _e2165);
let _e4450 = ((1f - (((select(_e4410, _e4406, _e487) + 0.5f) / _e2158) * 2f)) * _e2173);
let _e4457 = ((_e2176.member * _e4445) + (_e2184.member * _e4450));
let _e4458 = ((_e2176.member_1 * _e4445) + (_e2184.member_1 * _e4450));
let _e4459 = ((_e2176.member_2 * _e4445) + (_e2184.member_2 * _e4450));
let _e4463 = select((_e2199.member + _e4457), _e2199.member, _e2197);
let _e4464 = select((_e2199.member_1 + _e4458), _e2199.member_1, _e2197);
let _e4465 = select((_e2199.member_2 + _e4459), _e2199.member_2, _e2197);
let _e4476 = (((_e4463 * _e4463) + (_e4464 * _e4464)) + (_e4465 * _e4465));
let _e4480 = (1f / sqrt(select(0f, _e4476, (_e4476 > 0f))));
let _e4481 = (_e4463 * _e4480);
let _e4482 = (_e4464 * _e4480);
let _e4483 = (_e4465 * _e4480);
let _e4484 = (_e609 - select(_e2210.member, (_e2210.member + _e4457), _e2197));
let _e4485 = (_e621 - select(_e2210.member_1, (_e2210.member_1 + _e4458), _e2197));
let _e4486 = (_e634 - select(_e2210.member_2, (_e2210.member_2 + _e4459), _e2197));
let _e4491 = (((_e4484 * _e4481) + (_e4485 * _e4482)) + (_e4486 * _e4483));
let _e4496 = (((_e4484 * _e647) + (_e4485 * _e660)) + (_e4486 * _e673));
let _e4501 = (((_e4481 * _e647) + (_e4482 * _e660)) + (_e4483 * _e673));
let _e4504 = ((_e4482 * _e673) - (_e4483 * _e660));
let _e4507 = ((_e4483 * _e647) - (_e4481 * _e673));
let _e4510 = ((_e4481 * _e660) - (_e4482 * _e647));
let _e4515 = (((_e4504 * _e4504) + (_e4507 * _e4507)) + (_e4510 * _e4510));
let _e4518 = (1f / select(1e-9f, _e4515, (_e4515 > 1e-9f)));
let _e4521 = ((_e4491 - (_e4501 * _e4496)) * _e4518);
let _e4524 = (((_e4501 * _e4491) - _e4496) * _e4518);
let _e4530 = select(0f, _e4521, (((_e4524 >= 0f) && (_e4524 < _e725)) && (_e4521 > 0f)));
let _e4532 = (_e4399 << bitcast<u32>(_e3874));
let _e4544 = select(((((_e3873 - select(0f, (_e3935 * _e3936), (((select(select(_e800, _e957, (_e4080 >= _e726)), _e879, (_e4080 < _e332)) == _e1966) && (_e4078 > 0f)) && (_e4078 < _e3988)))) - select(0f, (_e3932 * _e3936), (((select(select(_e800, _e957, (_e4232 >= _e726)), _e879, (_e4232 < _e332)) == _e1966) && (_e4230 > 0f)) && (_e4230 < _e4140)))) - select(0f, (_e3935 * _e3934), (((select(select(_e800, _e957, (_e4384 >= _e726)), _e879, (_e4384 < _e332)) == _e1966) && (_e4382 > 0f)) && (_e4382 < _e4292)))) - select(0f, (_e3932 * _e3934), (((select(select(_e800, _e957, (_e4532 >= _e726)), _e879, (_e4532 < _e332)) == _e1966) && (_e4530 > 0f)) && (_e4530 < _e4440)))), _e3873, _e3966);
if _e487 {
phi_101762_ = type_26(_e2074, _e1981);
} else {
phi_101762_ = type_26(_e1981, _e2074);
}
let _e4559 = phi_101762_;
let _e4562 = (_e2075 && (((_e2530 > 0f) && (_e2530 < _e2154)) && (bitcast<f32>((bitcast<u32>(_e4544) & 2147483647u)) > 1e-6f)));
let _e4565 = global_1.member.member_18.member;
let _e4566 = (((select(_e2100, (1f - _e2100), (_e2085 >= 0f)) - select(_e2119, (1f - _e2119), (_e2104 >= 0f))) * (1f / _e2082)) * _e4565);
let _e4570 = select(0f, (((((_e686 * _e2517.member) * ((1f + (_e2398 * (1f + (_e2398 * (0.5f + (_e2398 * (0.16666667f + (_e2398 * (0.041666668f + (_e2398 * (0.008333334f + (_e2398 * (0.001388889f + (_e2398 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2393 + 127i)) << bitcast<u32>(23i))))) * _e2360) * _e4544) * _e4566), _e4562);
let _e4571 = select(0f, (((((_e699 * _e2517.member_1) * ((1f + (_e2446 * (1f + (_e2446 * (0.5f + (_e2446 * (0.16666667f + (_e2446 * (0.041666668f + (_e2446 * (0.008333334f + (_e2446 * (0.001388889f + (_e2446 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2441 + 127i)) << bitcast<u32>(23i))))) * _e2360) * _e4544) * _e4566), _e4562);
let _e4572 = select(0f, (((((_e712 * _e2517.member_2) * ((1f + (_e2494 * (1f + (_e2494 * (0.5f + (_e2494 * (0.16666667f + (_e2494 * (0.041666668f + (_e2494 * (0.008333334f + (_e2494 * (0.001388889f + (_e2494 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2489 + 127i)) << bitcast<u32>(23i))))) * _e2360) * _e4544) * _e4566), _e4562);
let _e4576 = (bitcast<f32>((bitcast<u32>(_e4570) & 2147483647u)) >= 1073741800f);
let _e4577 = (1f / 1048576f);
let _e4580 = ((_e4570 * select(1f, _e4577, _e4576)) + 0.5f);
let _e4582 = select(-1073741800f, _e4580, (_e4580 > -1073741800f));
let _e4584 = select(1073741800f, _e4582, (_e4582 < 1073741800f));
let _e4591 = select(0i, select(select(i32(_e4584), i32(-2147483648), (_e4584 < -2147483600f)), 2147483647i, (_e4584 > 2147483500f)), (_e4584 == _e4584));
let _e4595 = (_e4591 - select(0i, 1i, (_e4584 < f32(_e4591))));
let _e4596 = select(0i, 20i, _e4576);
let _e4600 = (bitcast<u32>(_e4595) << bitcast<u32>((_e4596 & 31i)));
let _e4607 = bitcast<u32>(((_e4595 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e4596) & 31i))));
let _e4611 = (bitcast<f32>((bitcast<u32>(_e4571) & 2147483647u)) >= 1073741800f);
let _e4614 = ((_e4571 * select(1f, _e4577, _e4611)) + 0.5f);
let _e4616 = select(-1073741800f, _e4614, (_e4614 > -1073741800f));
let _e4618 = select(1073741800f, _e4616, (_e4616 < 1073741800f));
let _e4625 = select(0i, select(select(i32(_e4618), i32(-2147483648), (_e4618 < -2147483600f)), 2147483647i, (_e4618 > 2147483500f)), (_e4618 == _e4618));
let _e4629 = (_e4625 - select(0i, 1i, (_e4618 < f32(_e4625))));
let _e4630 = select(0i, 20i, _e4611);
let _e4634 = (bitcast<u32>(_e4629) << bitcast<u32>((_e4630 & 31i)));
let _e4641 = bitcast<u32>(((_e4629 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e4630) & 31i))));
let _e4645 = (bitcast<f32>((bitcast<u32>(_e4572) & 2147483647u)) >= 1073741800f);
let _e4648 = ((_e4572 * select(1f, _e4577, _e4645)) + 0.5f);
let _e4650 = select(-1073741800f, _e4648, (_e4648 > -1073741800f));
let _e4652 = select(1073741800f, _e4650, (_e4650 < 1073741800f));
let _e4659 = select(0i, select(select(i32(_e4652), i32(-2147483648), (_e4652 < -2147483600f)), 2147483647i, (_e4652 > 2147483500f)), (_e4652 == _e4652));
let _e4663 = (_e4659 - select(0i, 1i, (_e4652 < f32(_e4659))));
let _e4664 = select(0i, 20i, _e4645);
let _e4668 = (bitcast<u32>(_e4663) << bitcast<u32>((_e4664 & 31i)));
let _e4675 = bitcast<u32>(((_e4663 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e4664) & 31i))));
let _e4680 = bitcast<i32>(bitcast<u32>((((_e4559.member_1 * _e966) + _e4559.member) * 6i)));
if ((_e4600 | _e4607) == 0u) {
} else {
let _e4683 = bitcast<u32>(_e4680);
if (_e4683 < _e304) {
let _e4687 = atomicAdd((&global_8.member[_e4683]), _e4600);
phi_101995_ = _e4687;
} else {
phi_101995_ = 0u;
}
let _e4689 = phi_101995_;
let _e4693 = (_e4607 + select(0u, 1u, ((_e4689 + _e4600) < _e4600)));
if (_e4693 == 0u) {
} else {
let _e4695 = (_e4683 + 1u);
if (_e4695 < _e304) {
let _e4699 = atomicAdd((&global_8.member[_e4695]), _e4693);
}
}
}
if ((_e4634 | _e4641) == 0u) {
} else {
let _e4703 = bitcast<u32>((_e4680 + 2i));
if (_e4703 < _e304) {
let _e4707 = atomicAdd((&global_8.member[_e4703]), _e4634);
phi_102025_ = _e4707;
} else {
phi_102025_ = 0u;
}
let _e4709 = phi_102025_;
let _e4713 = (_e4641 + select(0u, 1u, ((_e4709 + _e4634) < _e4634)));
if (_e4713 == 0u) {
} else {
let _e4715 = (_e4703 + 1u);
if (_e4715 < _e304) {
let _e4719 = atomicAdd((&global_8.member[_e4715]), _e4713);
}
}
}
if ((_e4668 | _e4675) == 0u) {
} else {
let _e4723 = bitcast<u32>((_e4680 + 4i));
if (_e4723 < _e304) {
let _e4727 = atomicAdd((&global_8.member[_e4723]), _e4668);
phi_102055_ = _e4727;
} else {
phi_102055_ = 0u;
}
let _e4729 = phi_102055_;
let _e4733 = (_e4675 + select(0u, 1u, ((_e4729 + _e4668) < _e4668)));
if (_e4733 == 0u) {
} else {
let _e4735 = (_e4723 + 1u);
if (_e4735 < _e304) {
let _e4739 = atomicAdd((&global_8.member[_e4735]), _e4733);
}
}
}
phi_87438_ = (_e2072 + 1i);
} else {
phi_87438_ = i32();
}
let _e4742 = phi_87438_;
continue;
continuing {
phi_87437_ = _e4742;
break if !(_e2075);
}
}
phi_87284_ = (_e1978 + 1i);
} else {
phi_87284_ = i32();
}
let _e4746 = phi_87284_;
continue;
continuing {
phi_87283_ = _e4746;
break if !(_e1979);
}
}
}
}
}
}
}
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
